// Messages between ranks: words of 64 bits, of one kind each.
#pragma once

#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <list>
#include <string>
#include <utility>
#include <vector>

#include "cromer/cluster/mpi_module.h"

namespace cromer::core {

using Words = std::vector<std::uint64_t>;

enum class Kind : int {
  hello,        ///< to the first: threads, then host and description as text
  chunk,        ///< from the first: a chunk to make
  rows,         ///< to the first: a chunk made
  problem,      ///< to the first: why this rank cannot go on: a Trouble's kind, then host and words as text
  interrupted,  ///< to the first: somebody wants this rank to stop
  stop,         ///< from the first: there is nothing more to do
  left,         ///< to the first: the last message of this rank
};

struct Message {
  int from = 0;
  Kind kind{};
  Words words{};
};

inline Words words_of(const std::string& text) {
  Words words(1 + (text.size() + 7) / 8);
  words[0] = text.size();
  std::memcpy(words.data() + 1, text.data(), text.size());
  return words;
}

/// A number, then texts.
inline Words words_of(std::uint64_t number, std::initializer_list<std::string> texts) {
  Words words = {number};
  for (const std::string& text : texts) {
    const Words more = words_of(text);
    words.insert(words.end(), more.begin(), more.end());
  }
  return words;
}

/// The text that begins at `at`, which goes on behind it.
inline std::string text_of(const Words& words, std::size_t& at) {
  std::string text(words.at(at), '\0');
  std::memcpy(text.data(), words.data() + at + 1, text.size());
  at += 1 + (text.size() + 7) / 8;
  return text;
}

/// Sends without waiting; the words live here until they are sent.
class Post {
 public:
  explicit Post(const CromerMpi* mpi) : mpi_(mpi) {}

  void send(int to, Kind kind, Words words) {
    auto& letter = letters_.emplace_back(Letter{std::move(words), nullptr});
    letter.sending = mpi_->send(to, static_cast<int>(kind), letter.words.data(), letter.words.size());
  }
  /// Whether all is sent.
  bool empty() {
    letters_.remove_if([&](const Letter& letter) { return mpi_->sent(letter.sending); });
    return letters_.empty();
  }
  bool receive(Message& message) {
    int kind = 0;
    std::size_t count = 0;
    if (!mpi_->arrived(&message.from, &kind, &count)) return false;
    message.kind = static_cast<Kind>(kind);
    message.words.resize(count);
    mpi_->receive(message.words.data());
    return true;
  }

 private:
  struct Letter {
    Words words;
    void* sending;
  };
  const CromerMpi* mpi_;
  std::list<Letter> letters_{};
};

}  // namespace cromer::core
