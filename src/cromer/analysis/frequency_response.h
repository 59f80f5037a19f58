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

/// A ratio of amplitudes, and how far the answer lags.
struct Transmission {
  double amplitude = 1;  ///< of the answer over that of the cause
  double phase_lag = 0;  // [rad] 0 to pi
};

/// T = |k + i c w|/|k - m w^2 + i c w| of the linear law: how much of a shaking base's displacement reaches
/// the mass, and as well how much of a force on the mass reaches the ground (J. P. Den Hartog, Mechanical
/// Vibrations, 4th ed., 1956, section 2.12). Error: as frequency_response.
inline Transmission transmissibility(const Oscillator<double>& oscillator, double w) {
  const double k = oscillator.stiffness, quadrature = oscillator.damping * w;
  const double in_phase = k - oscillator.mass * (w * w);
  return {std::hypot(k, quadrature) / std::hypot(in_phase, quadrature),
          std::atan2(quadrature, in_phase) - std::atan2(quadrature, k)};
}

/// |m w^2|/|k - m w^2 + i c w|: the displacement relative to a shaking base over the base's own; of a
/// rotating unbalance m x/(m_u e).
inline Transmission relative_transmissibility(const Oscillator<double>& oscillator, double w) {
  const SteadyState answer = frequency_response(oscillator, oscillator.mass * (w * w), w);
  return {answer.amplitude, answer.phase_lag};
}

/// The force on the ground over m_u e w0^2, w0^2 = k/m, of a rotating unbalance: (w/w0)^2 T. k > 0.
inline Transmission unbalance_transmissibility(const Oscillator<double>& oscillator, double w) {
  Transmission t = transmissibility(oscillator, w);
  t.amplitude *= oscillator.mass * (w * w) / oscillator.stiffness;
  return t;
}

/// Where the steady amplitude is largest [rad/s]: sqrt(k/m - 2 (c/2m)^2), or 0 if it falls from the start. k
/// > 0.
inline double resonance_frequency(const Oscillator<double>& oscillator) {
  const double b = oscillator.damping / (2 * oscillator.mass);
  const double squared = oscillator.stiffness / oscillator.mass - 2 * b * b;
  return squared > 0 ? std::sqrt(squared) : 0;
}

}  // namespace cromer
