// Several pieces of work at once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#ifndef CROMER_PAGE
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>
#endif

namespace cromer::core {

/// Calls work(i) once for each i below `count`, in this order, on up to as many threads as the machine has
/// (at least two), the first on the calling one. No call begins before all that are `ahead` > 0 or more
/// before it have ended: it may read what they wrote. ended(i) follows each, in this order and one at a time,
/// from whatever thread. No call may throw, nor write what another reads.
template <class Work, class Ended>
void at_once(std::size_t count, const Work& work, std::size_t ahead, const Ended& ended) {
#ifdef CROMER_PAGE
  (void)ahead;
  for (std::size_t i = 0; i < count; ++i) work(i), ended(i);
#else
  if (count == 0) return;
  std::mutex mutex;
  std::condition_variable changed;
  std::size_t next = 1, all_before = 0;  // those below have ended
  std::vector<char> done(count);
  const auto end = [&](std::size_t i) {
    const std::lock_guard lock(mutex);
    done[i] = 1;
    while (all_before < count && done[all_before]) ended(all_before++);
    changed.notify_all();
  };
  const auto take = [&] {
    for (;;) {
      std::unique_lock lock(mutex);
      if (next >= count) return;
      const std::size_t i = next++;
      changed.wait(lock, [&] { return i < ahead || all_before > i - ahead; });
      lock.unlock();
      work(i);
      end(i);
    }
  };
  const std::size_t threads = std::min<std::size_t>(count, std::max(2U, std::thread::hardware_concurrency()));
  std::vector<std::thread> beside;
  beside.reserve(threads - 1);
  try {
    while (beside.size() + 1 < threads) beside.emplace_back(take);
  } catch (const std::system_error&) {  // the threads there are do it
  }
  work(0);
  end(0);
  take();
  for (std::thread& each : beside) each.join();
#endif
}

/// The same of pieces that do not depend on each other.
template <class Work>
void at_once(std::size_t count, const Work& work) {
  at_once(count, work, std::numeric_limits<std::size_t>::max(), [](std::size_t) {});
}

}  // namespace cromer::core
