// The law of motion: m x'' = F(t) - k x - k3 x^3 - c x' - d x'|x'| - f sgn(x').
#pragma once

namespace cromer {

/// The coefficients of the law, SI throughout.
template <class Real>
struct Oscillator {
  Real mass = 1;       // [kg] > 0
  Real stiffness = 1;  // [N/m] any sign: negative with a cubic is a double well
  Real damping = 0;    // [kg/s] >= 0
  Real drag = 0;       // [kg/m] >= 0
  Real friction = 0;   // [N] >= 0, while it slides
  Real cubic = 0;      // [N/m^3] any sign

  Real static_friction = 0;  // [N] most that holds it at rest; below `friction` it counts as `friction`

  friend bool operator==(const Oscillator&, const Oscillator&) = default;
};

}  // namespace cromer
