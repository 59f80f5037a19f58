// How fast the air sees the disc move.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace cromer::core {

/// Re = |v| D / nu, with D [m] the diameter and nu [m^2/s] > 0 the kinematic viscosity.
double reynolds_number(double v, double D, double nu);

/// The largest |v| within [t, t + length).
struct SpeedWindow {
  double t = 0;      // [s] where the window begins
  double speed = 0;  // [m/s]
  double at = 0;     // [s] when it is reached
};

/// Whole windows of `length` [s] > 0 from t.front() on; those without a sample are left out. Between samples
/// the speed is taken at the top of the parabola through three of them. A window shorter than half a period
/// may miss every top: then its value says nothing of the motion's scale.
std::vector<SpeedWindow> speed_windows(std::span<const double> t, std::span<const double> v, double length);

}  // namespace cromer::core
