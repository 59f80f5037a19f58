// What a force that begins as a constant or as a ramp does to the linear law:
//
//   step(tau) = integral from 0 to tau of g,  ramp(tau) = integral from 0 to tau of step,
//
// g the impulse response of propagate.h. They are the divided differences of z -> e^{z tau} at 0, r1, r2 and
// at 0, 0, r1, r2. With g'' + 2 b g' + s g = 0 integrated once and twice,
//
//   s step = 1 - (g' + 2 b g),    s ramp = tau - g - 2 b step,
//
// which lose their digits where tau is short or a root is near 0: there the power series, or the difference
// of the two remaining nodes, which lie far apart. Every branch is smooth in b and s, so duals carry right
// derivatives. N. C. Nigam & P. C. Jennings, Bull. Seism. Soc. Am. 59, 909 (1969), give the formulas for the
// underdamped law only.
//
// Error: a few rounding errors, relative, of each.
#pragma once

#include <cmath>

#include "cromer/base/dual.h"
#include "cromer/model/propagate.h"

namespace cromer::core {

/// The motion from rest under the force (per unit mass) 1, and under t.
template <class Real>
struct RampResponse {
  Real step;  // [s^2]
  Real ramp;  // [s^3]
};

/// (e^z - 1 - z)/z^2 for |z| <= 1/2.
template <class Real>
Real exponential_remainder(const Real& z) {
  Real sum(1);
  for (int n = 15; n > 0; --n) sum = Real(1) + z * sum / Real(n + 2);
  return sum / Real(2);
}

/// Of any tau >= 0 [s], given impulse_response(law, tau).
template <class Real>
RampResponse<Real> ramp_response(const LinearLaw<Real>& law, const ImpulseResponse<Real>& free,
                                 const Real& tau) {
  using std::sqrt;
  const Real b = law.decay_rate, s = law.stiffness;
  const double b_tau = value_of(b * tau), s_tau2 = value_of(s * tau * tau);

  if (std::abs(b_tau) <= 1 && std::abs(s_tau2) <= 1) {
    // p[n], the n-th Taylor term of step: n (n - 1) p[n] = -2 b tau (n - 1) p[n-1] - s tau^2 p[n-2].
    Real before(0), last = tau * tau / Real(2);
    RampResponse<Real> sum{last, last * tau / Real(3)};
    for (int n = 3; n < 34; ++n) {
      const Real next =
          Real(-1.0 / (n * (n - 1))) * (Real(2 * (n - 1)) * (b * tau) * last + (s * tau * tau) * before);
      before = last;
      last = next;
      sum.step = sum.step + next;
      sum.ramp = sum.ramp + next * tau / Real(n + 1);
      // Two in a row: without damping every second term is 0. Of short intervals the rest is nothing.
      if (std::abs(value_of(next)) + std::abs(value_of(before)) < 1e-25 * std::abs(value_of(sum.step))) break;
    }
    return sum;
  }

  const Real discriminant = s - b * b;
  if (value_of(discriminant) < 0) {
    const Real q = sqrt(-discriminant), slow = -s / (q + b), fast = q + b;
    const Real z = slow * tau;
    if (std::abs(value_of(z)) < 0.25) {
      const Real remainder = exponential_remainder(z);
      const Real step = (tau * (Real(1) + z * remainder) - free.g) / fast;
      return {step, (tau * tau * remainder - step) / fast};
    }
  }
  const Real step = (Real(1) - free.position) / s;
  return {step, (tau - free.g - Real(2) * b * step) / s};
}

/// The state tau after y0 under the force level + slope * u, u from 0 to tau (per unit mass; the drive of the
/// law is not looked at).
template <class Real>
State<Real> propagate_ramp(const LinearLaw<Real>& law, const Real& level, const Real& slope, const Real& tau,
                           const State<Real>& y0) {
  const ImpulseResponse<Real> free = impulse_response(law, tau);
  const RampResponse<Real> driven = ramp_response(law, free, tau);
  return {free.position * y0.x + free.g * y0.v + level * driven.step + slope * driven.ramp,
          free.slope * y0.v - law.stiffness * free.g * y0.x + level * free.g + slope * driven.step};
}

}  // namespace cromer::core
