// The threads of a rank. They make the chunks that they are given, while another thread talks to the other
// ranks.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cromer/ensemble/chunks.h"
#include "cromer/notice.h"

namespace cromer::core {

/// A finished chunk: the words of a message, its number first, then the rows.
struct MadeChunk {
  std::vector<std::uint64_t> words{};
  std::uint64_t chunk() const { return words.front(); }
  const double* rows() const { return reinterpret_cast<const double*>(words.data() + 1); }
};

/// What went wrong in making chunks, as it is told to another rank.
struct Trouble {
  enum class Kind : std::uint64_t { none, not_made, no_memory, in_words } kind = Kind::none;
  std::string words{};  ///< of kind in_words
  bool empty() const { return kind == Kind::none; }
};
Notice notice_of(const Trouble& trouble);

/// Threads that make chunks. All calls come from one other thread.
class Crew {
 public:
  /// `work` outlives it.
  Crew(const ChunkedRows& work, int threads);
  ~Crew() {
    stop();
    thread_.join();
  }
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  void give(std::uint64_t chunk);
  std::optional<MadeChunk> take();

  /// Drops the chunks that were given but not begun, and breaks off those in progress as soon as possible.
  void stop();
  /// After stop(): whether no more chunks will come. Those already made can still be taken.
  bool gone();

  /// Waits until a chunk is made, but no longer than this.
  void wait(std::chrono::microseconds patience);

  /// What went wrong in making chunks, if anything did.
  Trouble trouble();

 private:
  void run(const ChunkedRows& work, int threads);

  std::mutex mutex_{};
  std::condition_variable given_or_stopped_{}, made_or_gone_{};
  std::deque<std::uint64_t> given_{};
  std::deque<MadeChunk> made_{};
  std::atomic<bool> stop_{false};
  bool gone_ = false;
  Trouble trouble_{};
  std::thread thread_;
};

}  // namespace cromer::core
