// The law of motion:
//
//   m x'' = F(t) - k x - k2 x^2 - ka x|x| - k3 x^3 - k5 x^5 - p sin x
//           - c x' - e x^2 x' - d x'|x'| - f sgn x' - z,
//   z' = A x' - beta |x'| |z|^(n-1) z - gamma x' |z|^n
#pragma once

namespace cromer {

/// The coefficients of the law over any scalar, SI throughout; each belongs to one term. Of an angle x [rad]
/// the mass is a moment of inertia [kg m^2] and forces are torques [N m]. Hysteresis and friction do not go
/// together in one run.
template <class Real>
struct OscillatorOf {
  Real mass = 1;       // [kg] > 0
  Real stiffness = 1;  // [N/m] any sign: negative with a cubic is a double well
  Real damping = 0;    // [kg/s] >= 0, negative beside van_der_pol only
  Real drag = 0;       // [kg/m] >= 0
  Real friction = 0;   // [N] >= 0, while it slides
  Real cubic = 0;      // [N/m^3] any sign

  Real static_friction = 0;  // [N] largest that holds it at rest; below `friction` it counts as `friction`

  Real quadratic = 0;      // [N/m^2] any sign
  Real odd_quadratic = 0;  // [N/m^2] any sign
  Real quintic = 0;        // [N/m^5] any sign
  Real pendulum = 0;       // [N] any sign, of sin x, x an angle [rad]
  Real van_der_pol = 0;    // [kg/(m^2 s)] any sign

  Real hysteresis_stiffness = 0;  // [N/m] A
  Real hysteresis_beta = 0;       // [1/m]; N^(1-n)/m with an exponent n
  Real hysteresis_gamma = 0;      // [1/m], likewise
  Real hysteresis_exponent = 1;   ///< n >= 1

  friend bool operator==(const OscillatorOf&, const OscillatorOf&) = default;
};

using Oscillator = OscillatorOf<double>;

/// The linear oscillator of a natural angular frequency [rad/s] > 0, damping ratio >= 0 and mass [kg] > 0:
/// k = m w0^2, c = 2 zeta m w0.
constexpr Oscillator with_frequency(double natural_frequency, double damping_ratio, double mass = 1) {
  return {.mass = mass,
          .stiffness = mass * natural_frequency * natural_frequency,
          .damping = 2 * damping_ratio * mass * natural_frequency};
}

}  // namespace cromer
