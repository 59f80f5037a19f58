// Many records at once, each the same on every machine.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string_view>
#include <thread>
#include <vector>

namespace cromer::core::bench {

/// Called with the number of records done, from any thread but never from two at a time.
using Progress = std::function<void(std::size_t)>;

/// Calls work(i) for i below n on all processors.
template <class Work>
void in_parallel(std::size_t n, const Progress& progress, Work work) {
  std::atomic<std::size_t> next{0}, done{0};
  std::mutex telling;
  const auto run = [&] {
    for (std::size_t i; (i = next++) < n;) {
      work(i);
      if (const std::size_t count = ++done; count % 50 == 0) {
        const std::lock_guard lock(telling);
        progress(count);
      }
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < std::max(1u, std::thread::hardware_concurrency()); ++i) threads.emplace_back(run);
  run();
  for (std::thread& thread : threads) thread.join();
}

/// Of record i of a row.
inline std::uint64_t seed_of(std::string_view law, std::string_view condition, std::size_t i) {
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
  for (std::string_view text : {law, condition})
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash + i * 0x9E3779B97F4A7C15u;
}

}  // namespace cromer::core::bench
