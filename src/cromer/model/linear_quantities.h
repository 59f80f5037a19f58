// Frequencies and dampings of the linear part of a law.
#pragma once

#include <cmath>
#include <numbers>

#include "cromer/model/oscillator.h"
#include "cromer/model/propagate.h"

namespace cromer::core {

/// Decay rate of the free motion's envelope, c/2m [1/s].
inline double decay_rate(const Oscillator<double>& o) { return o.damping / (2 * o.mass); }

/// The frequency without damping, sqrt(k/m) [rad/s]; 0 where the spring does not pull back.
inline double natural_frequency(const Oscillator<double>& o) {
  return o.stiffness > 0 ? std::sqrt(o.stiffness / o.mass) : 0;
}

/// The linear part of the law, per unit mass, with its drive.
inline LinearLaw<double> linear_law(const Oscillator<double>& o, const HarmonicDrive<double>& drive = {}) {
  return {.decay_rate = decay_rate(o),
          .stiffness = o.stiffness / o.mass,
          .drive_amplitude = drive.amplitude / o.mass,
          .drive_frequency = drive.frequency,
          .drive_phase = drive.phase};
}

/// The frequency of the damped free motion [rad/s]; 0 where it does not swing.
inline double damped_frequency(const Oscillator<double>& o) { return damped_frequency(linear_law(o)); }

/// The smallest damping at which the free motion does not swing, 2 sqrt(k m) [kg/s]; 0 where the spring does
/// not pull back.
inline double critical_damping(const Oscillator<double>& o) {
  return o.stiffness > 0 ? 2 * std::sqrt(o.stiffness * o.mass) : 0;
}

/// c over the critical damping; infinite or NaN where that is 0.
inline double damping_ratio(const Oscillator<double>& o) { return o.damping / critical_damping(o); }

/// sqrt(k m) over c; infinite or NaN without damping.
inline double quality_factor(const Oscillator<double>& o) { return critical_damping(o) / (2 * o.damping); }

/// The factor of the energy from one cycle of the free motion to the next; 0 where it does not swing.
inline double energy_factor_per_cycle(const Oscillator<double>& o) {
  const double w = damped_frequency(o);
  return w > 0 ? std::exp(-4 * std::numbers::pi * decay_rate(o) / w) : 0;
}

}  // namespace cromer::core
