// The threads of a rank: they make the chunks that they are given, while another thread talks to the ranks.
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
  std::string words{};  ///< of those who said it so
  bool empty() const { return kind == Kind::none; }
};
Notice notice_of(const Trouble& trouble);

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

  /// Chunks given but not begun are dropped, those in work are left as soon as may be.
  void stop();
  /// After stop(): nothing more will come; what was made can still be taken.
  bool gone();

  /// Waits until a chunk is made, but not longer.
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
