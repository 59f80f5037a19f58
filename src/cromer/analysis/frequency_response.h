// The steady motion x = X cos(w t + phi - delta) of the linear law under F cos(w t + phi).
#pragma once

#include <cmath>
#include <numbers>

#include "cromer/base/dual.h"
#include "cromer/base/pi.h"
#include "cromer/model/linear_quantities.h"
#include "cromer/model/oscillator.h"

namespace cromer::core {

struct SteadyState {
  double amplitude = 0;  // [m] X
  double phase_lag = 0;  // [rad] delta, 0 to pi
};

/// X = F/|k - m w^2 + i c w|, delta the angle of that number; cubic, drag and friction are ignored.
/// Infinite at undamped resonance. Error: a few rounding errors of k, relative to |k - m w^2 + i c w|.
inline SteadyState frequency_response(const Oscillator<double>& oscillator, double force_amplitude,
                                      double w) {
  const double in_phase = oscillator.stiffness - oscillator.mass * (w * w);
  const double quadrature = oscillator.damping * w;
  return {force_amplitude / std::hypot(in_phase, quadrature), std::atan2(quadrature, in_phase)};
}

/// The same of a spring with hysteretic (structural) damping, k (1 + i eta) with the loss factor eta >= 0
/// in place of the damper: X = F/|k - m w^2 + i eta k|. At resonance it damps as a damper of damping ratio
/// eta/2 does; its loss per cycle does not depend on the frequency. Defined for steady states alone: no law
/// in time gives it (S. H. Crandall, J. Sound Vib. 11, 3 (1970)).
inline SteadyState hysteretic_response(const Oscillator<double>& oscillator, double loss_factor,
                                       double force_amplitude, double w) {
  const double in_phase = oscillator.stiffness - oscillator.mass * (w * w);
  const double quadrature = loss_factor * oscillator.stiffness;
  return {force_amplitude / std::hypot(in_phase, quadrature), std::atan2(quadrature, in_phase)};
}

/// A ratio of amplitudes, and how far the answer lags.
struct Transmission {
  double amplitude = 1;  ///< of the answer over that of the cause
  double phase_lag = 0;  // [rad] 0 to pi but for a method's own error
};

/// Amplitude and lag of `cosine` cos u + `sine` sin u relative to cos u; the lag from -pi/2 to 3 pi/2.
inline Transmission transmission(double cosine, double sine) {
  double lag = std::atan2(sine, cosine);
  if (lag < -std::numbers::pi / 2) lag += two_pi;
  return {std::hypot(cosine, sine), lag};
}

/// T = |k + i c w|/|k - m w^2 + i c w| of the linear law: how much of a shaking base's displacement reaches
/// the mass, and as well how much of a force on the mass reaches the ground (J. P. Den Hartog, Mechanical
/// Vibrations, 4th ed., 1956, section 2.12). Error: as frequency_response.
inline Transmission transmissibility(const Oscillator<double>& oscillator, double w) {
  const double k = oscillator.stiffness, quadrature = oscillator.damping * w;
  const double in_phase = k - oscillator.mass * (w * w);
  return {std::hypot(k, quadrature) / std::hypot(in_phase, quadrature),
          std::atan2(quadrature, in_phase) - std::atan2(quadrature, k)};
}

/// What becomes of a shaking base's Y cos u, Y > 0, where the mass moves X cos(u - delta) relative to it: the
/// mass's own displacement over the base's. However X and delta were found: exactly, by a method, measured.
inline Transmission transmitted_motion(double base_amplitude, const SteadyState& relative) {
  const double x = relative.amplitude / base_amplitude;
  return transmission(1 + x * std::cos(relative.phase_lag), x * std::sin(relative.phase_lag));
}

/// What becomes of a force F cos u, F > 0, on a mass with this position and velocity: the force k x + c v of
/// spring and damper on the ground over F. A method's velocity need not be the derivative of its position.
inline Transmission transmitted_force(const Oscillator<double>& oscillator, double force_amplitude,
                                      const SteadyState& position, const SteadyState& velocity) {
  const double spring = oscillator.stiffness * position.amplitude / force_amplitude;
  const double damper = oscillator.damping * velocity.amplitude / force_amplitude;
  return transmission(spring * std::cos(position.phase_lag) + damper * std::cos(velocity.phase_lag),
                      spring * std::sin(position.phase_lag) + damper * std::sin(velocity.phase_lag));
}

/// Where the steady amplitude is largest [rad/s]: sqrt(k/m - 2 (c/2m)^2), or 0 if the amplitude falls from
/// w = 0 on; k > 0.
inline double resonance_frequency(const Oscillator<double>& oscillator) {
  const double b = decay_rate(oscillator);
  const double squared = oscillator.stiffness / oscillator.mass - 2 * b * b;
  return squared > 0 ? std::sqrt(squared) : 0;
}

}  // namespace cromer::core
