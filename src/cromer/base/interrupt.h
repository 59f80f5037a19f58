// How work that takes long is told to stop, and tells how far it is. Clocks and signals stay with the
// caller.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

namespace cromer::core {

/// Handed to everything that may take long; all members may be empty.
struct Watch {
  const std::atomic<bool>* interrupt =
      nullptr;  ///< set by the caller (a signal, a button); looked at every few hundred steps
  std::function<void(double fraction)>
      progress{};                 ///< called now and then with 0 to 1, from the working thread
  std::function<void()> pulse{};  ///< called at each look at interrupted(), from whatever thread works
  std::shared_ptr<std::atomic<double>>
      steps_left{};  ///< integration steps left before the work ends; empty: no limit

  void take_steps(double count) const {
    if (!steps_left) return;
    double left = steps_left->load();
    while (!steps_left->compare_exchange_weak(left, left - count)) {
    }
  }
  bool out_of_steps() const { return steps_left && *steps_left < 0; }
  bool interrupted() const {
    if (pulse) pulse();
    return (interrupt && interrupt->load(std::memory_order_relaxed)) || out_of_steps();
  }
};

/// The Watch of work that tells nothing of how far it is, but can be stopped.
inline Watch without_progress(const Watch& whole) { return {whole.interrupt, {}, whole.pulse}; }

/// The Watch of the part of the work from share `from` to share `to`, 0 <= from <= to <= 1. `whole` must
/// outlive it.
inline Watch part_of(const Watch& whole, double from, double to) {
  Watch part = without_progress(whole);
  if (whole.progress)
    part.progress = [&whole, from, to](double fraction) { whole.progress(from + (to - from) * fraction); };
  return part;
}

}  // namespace cromer::core
