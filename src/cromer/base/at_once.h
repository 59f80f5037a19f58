// Several pieces of work at once.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

#ifndef CROMER_PAGE
#include <system_error>
#include <thread>
#include <vector>
#endif

namespace cromer::core {

/// Calls work(i) once for each i below `count`, on up to as many threads as the machine has (at least two),
/// the first on the calling one. No call may throw, nor write what another reads.
template <class Work>
void at_once(std::size_t count, const Work& work) {
  if (count == 0) return;
  std::atomic<std::size_t> next = 1;
  const auto take = [&] {
    for (std::size_t i; (i = next.fetch_add(1)) < count;) work(i);
  };
#ifndef CROMER_PAGE
  const std::size_t threads = std::min<std::size_t>(count, std::max(2U, std::thread::hardware_concurrency()));
  std::vector<std::thread> beside;
  beside.reserve(threads - 1);
  try {
    while (beside.size() + 1 < threads) beside.emplace_back(take);
  } catch (const std::system_error&) {  // the threads there are do it
  }
#endif
  work(0);
  take();
#ifndef CROMER_PAGE
  for (std::thread& each : beside) each.join();
#endif
}

}  // namespace cromer::core
