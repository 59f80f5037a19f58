// The steps of a run, and how many states it will keep: known before it starts.
#pragma once

#include <cmath>
#include <limits>

namespace cromer::core {

/// From the first to the last time of a run.
struct Interval {
  double from = 0;   // [s]
  double until = 0;  // [s] >= from
};

/// Whole steps, and the shorter one that ends the run where they do not fill the interval.
struct Steps {
  long long whole = 0;
  double last = 0;  // [s] 0 if there is no shorter one

  long long count() const { return whole + (last > 0); }
};

/// An interval that is a whole number of steps to 1e-9 of a step has no shorter one. step [s] > 0. Beyond
/// 2^53 steps, where times can no longer be told apart, the count saturates.
inline Steps count_steps(Interval interval, double step) {
  constexpr double largest = 9007199254740992.0;  // 2^53
  const double steps = (interval.until - interval.from) / step;
  if (!(steps > 0)) return {};
  if (steps >= largest) return {.whole = static_cast<long long>(largest)};
  // Many steps carry the rounding of the quotient itself.
  const double slack = std::fmax(1e-9, 4 * std::numeric_limits<double>::epsilon() * steps);
  const double nearest = std::round(steps);
  if (std::abs(steps - nearest) <= slack && nearest > 0) return {.whole = static_cast<long long>(nearest)};
  const double whole = std::floor(steps);
  return {.whole = static_cast<long long>(whole), .last = interval.until - (interval.from + whole * step)};
}

/// States 0, every, 2 every, ... of the run, for every >= 1. Each takes 24 bytes in a Trajectory.
inline long long number_of_kept_states(Steps steps, long long every) { return steps.count() / every + 1; }

}  // namespace cromer::core
