// When a force may turn: what stands still under it needs to know how long the pull only rises or only falls.
//
// Every force has next_turn(t), the first time after t [s] at which it may turn or jump; infinite where there
// is none. In between it is monotonic, so that its values at both ends bound it.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

namespace cromer::core {

/// The first time after t at which cos(angle) turns, where the angle passes a multiple of pi: angle_at(t)
/// never falls, time_of(angle) is its inverse, and not a number or infinite for an angle that is never
/// reached.
template <class AngleAt, class TimeOf>
double time_of_next_half_turn(double t, const AngleAt& angle_at, const TimeOf& time_of) {
  const double passed = std::floor(angle_at(t) / std::numbers::pi);
  // The next multiple may be t itself, rounded.
  for (int i = 1; i <= 2; ++i)
    if (const double next = time_of((passed + i) * std::numbers::pi); next > t) return next;
  return std::numeric_limits<double>::infinity();
}

}  // namespace cromer::core
