// How clearly a stretch of an axis swings.
#pragma once

#include <span>

namespace cromer::core {

/// The strongest line of a stretch.
struct AxisSwing {
  double amplitude = 0;          ///< in the unit of the values
  double share = 0;              ///< of the variance, 0 to 1
  double angular_frequency = 0;  // [rad/s]

  double clearness() const { return amplitude * share; }
};

/// Of samples at times t [s], increasing, at a rate [1/s]; nothing of fewer than four, of a stretch that does
/// not move, and where times lie a hundred times as far apart as the rate says.
AxisSwing swing_in(std::span<const double> t, std::span<const double> y, double rate);

}  // namespace cromer::core
