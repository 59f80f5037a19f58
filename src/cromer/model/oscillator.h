// The law of motion, as the whole house writes it, and its harmonic drive. The terms of the law stand in
// terms/, one header each.
#pragma once

#include "cromer/oscillator.h"

namespace cromer::core {

template <class Real>
using Oscillator = OscillatorOf<Real>;

/// F cos(w t + phi), t from the start of the run.
template <class Real>
struct HarmonicDrive {
  Real amplitude = 0;  // [N] >= 0; 0 means no drive
  Real frequency = 0;  // [rad/s] >= 0, angular
  Real phase = 0;      // [rad]

  friend bool operator==(const HarmonicDrive&, const HarmonicDrive&) = default;
};

}  // namespace cromer::core
