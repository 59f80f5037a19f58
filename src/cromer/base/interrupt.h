// How long work learns that it should stop, and tells how far it is. Clocks and signals stay with the caller.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace cromer {

/// Handed to everything that may take long; all members may be empty.
struct Watch {
  const std::atomic<bool>* interrupt =
      nullptr;  ///< set by the caller (a signal, a button); looked at every few hundred steps
  std::function<void(double fraction)>
      progress{};  ///< called now and then with 0 to 1, from the working thread
  std::function<void(const std::vector<std::string>&)>
      warn{};  ///< called once, before long work, with what is wrong about it

  bool interrupted() const { return interrupt && interrupt->load(std::memory_order_relaxed); }
};

}  // namespace cromer
