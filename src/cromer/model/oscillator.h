// The law of motion:
//
//   m x'' = F(t) - k x - k2 x^2 - ka x|x| - k3 x^3 - k5 x^5 - p sin x
//           - c x' - e x^2 x' - d x'|x'| - f sgn x' - z,
//   z' = A x' - beta |x'| |z|^(n-1) z - gamma x' |z|^n
//
// The terms stand in terms/, one header each.
#pragma once

namespace cromer {

/// The coefficients of the law, SI throughout; each belongs to one term.
template <class Real>
struct Oscillator {
  Real mass = 1;       // [kg] > 0
  Real stiffness = 1;  // [N/m] any sign: negative with a cubic is a double well
  Real damping = 0;    // [kg/s] >= 0, negative beside van-der-pol only
  Real drag = 0;       // [kg/m] >= 0
  Real friction = 0;   // [N] >= 0, while it slides
  Real cubic = 0;      // [N/m^3] any sign

  Real static_friction = 0;  // [N] most that holds it at rest; below `friction` it counts as `friction`

  Real quadratic = 0;      // [N/m^2] any sign
  Real odd_quadratic = 0;  // [N/m^2] any sign
  Real quintic = 0;        // [N/m^5] any sign
  Real pendulum = 0;       // [N] of sin x, x an angle [rad]
  Real van_der_pol = 0;    // [kg/(m^2 s)] any sign

  Real hysteresis_stiffness = 0;  // [N/m] A
  Real hysteresis_beta = 0;       // [1/m], with an exponent of 1
  Real hysteresis_gamma = 0;      // [1/m], with an exponent of 1
  Real hysteresis_exponent = 1;   ///< n >= 1

  friend bool operator==(const Oscillator&, const Oscillator&) = default;
};

}  // namespace cromer
