// A spring that yields under a recorded ground motion: elastoplastic, its force never above that of yield.
#pragma once

#include <span>

namespace cromer::core {

/// An oscillator of a natural frequency w [rad/s] and a damping ratio, on a ground whose acceleration [m/s^2]
/// is straight between samples `spacing` [s] apart. At rest at the first sample.
struct YieldingOscillator {
  std::span<const double> acceleration;
  double spacing = 0;  // > 0
  double w = 0;        // > 0
  double damping_ratio = 0;

  /// The largest displacement [m] until the last sample, as a magnitude, where the spring yields at
  /// `yield_displacement` [m] > 0; 1e-4 of itself.
  double peak(double yield_displacement) const;

  /// The largest yield displacement [m] whose peak is `ductility` > 1 times as large (A. K. Chopra, Dynamics
  /// of Structures, 7.5.3); `elastic_peak` is that of a spring that never yields. NaN if a ten-thousandth of
  /// it is not weak enough.
  double yield_displacement(double ductility, double elastic_peak) const;
};

}  // namespace cromer::core
