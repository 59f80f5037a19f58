// The steady motion x = X cos(w t + phi - delta) of the linear law under F cos(w t + phi).
#pragma once

#include <cmath>

#include "cromer/base/dual.h"
#include "cromer/model/oscillator.h"

namespace cromer {

struct SteadyState {
  double amplitude = 0;  // [m] X
  double phase_lag = 0;  // [rad] delta, 0 to pi
};

/// X = F/|k - m w^2 + i c w|, delta the angle of that number; cubic, drag and friction are not looked at.
/// Infinite at undamped resonance. Error: a few rounding errors of k, relative to |k - m w^2 + i c w|.
inline SteadyState frequency_response(const Oscillator<double>& oscillator, double force_amplitude,
                                      double w) {
  const double in_phase = oscillator.stiffness - oscillator.mass * (w * w);
  const double quadrature = oscillator.damping * w;
  return {force_amplitude / std::hypot(in_phase, quadrature), std::atan2(quadrature, in_phase)};
}

/// Where the steady amplitude is largest [rad/s]: sqrt(k/m - 2 (c/2m)^2), or 0 if it falls from the start. k
/// > 0.
inline double resonance_frequency(const Oscillator<double>& oscillator) {
  const double b = oscillator.damping / (2 * oscillator.mass);
  const double squared = oscillator.stiffness / oscillator.mass - 2 * b * b;
  return squared > 0 ? std::sqrt(squared) : 0;
}

}  // namespace cromer
