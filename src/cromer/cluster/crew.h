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

namespace cromer::core {

/// A finished chunk: the words of a message, its number first, then the rows.
struct MadeChunk {
  std::vector<std::uint64_t> words{};
  std::uint64_t chunk() const { return words.front(); }
  const double* rows() const { return reinterpret_cast<const double*>(words.data() + 1); }
};

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

  /// What went wrong in making chunks, or "".
  std::string problem();

 private:
  void run(const ChunkedRows& work, int threads);

  std::mutex mutex_{};
  std::condition_variable given_or_stopped_{}, made_or_gone_{};
  std::deque<std::uint64_t> given_{};
  std::deque<MadeChunk> made_{};
  std::atomic<bool> stop_{false};
  bool gone_ = false;
  std::string problem_{};
  std::thread thread_;
};

}  // namespace cromer::core
