// The exact motion of the linear law, first with a harmonic drive,
//
//   x'' + 2 b x' + s x = f cos(W t + phi),      2 b = c/m >= 0,  s = k/m of any sign,  f = F/m.
//
// With the impulse response g (g(0) = 0, g'(0) = 1) and tau = t - t0 it is
//
//   x = (g' + 2 b g) x0 + g v0 + f Re(e^{i (W t0 + phi)} P),
//   v = -s g x0 + g' v0 + f Re(e^{i (W t0 + phi)} P'),
//   P(tau) = integral from 0 to tau of g(u) e^{i W (tau - u)} du,    P' = g + i W P.
//
// g is the first divided difference of z -> e^{z tau} at the roots r1, r2 of z^2 + 2 b z + s, and P the
// second one at i W, r1, r2. Evaluated as differences they fail where nodes meet: at critical damping (r1 =
// r2), at undamped resonance (i W = r1), and for constant force on a free mass (all three). Here every branch
// is a smooth function of b, s and W, so duals carry right derivatives through those points as well. Divided
// differences of exp: McCurdy, Ng & Parlett, Math. Comp. 43, 501 (1984).
//
// Error: a few rounding errors of the phase, about 2e-16 (1 + W |t| + w |tau|) of the amplitude.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "cromer/base/complex.h"
#include "cromer/base/dual.h"
#include "cromer/base/state.h"

namespace cromer::core {

/// The linear law per unit mass.
template <class Real>
struct LinearLaw {
  Real decay_rate = 0;       // [1/s] b = c/2m >= 0
  Real stiffness = 1;        // [1/s^2] s = k/m, any sign
  Real drive_amplitude = 0;  // [m/s^2] f = F/m
  Real drive_frequency = 0;  // [rad/s] W >= 0
  Real drive_phase = 0;      // [rad]
};

/// The frequency of the damped free motion [rad/s]; 0 where it does not swing.
inline double damped_frequency(const LinearLaw<double>& law) {
  const double squared = law.stiffness - law.decay_rate * law.decay_rate;
  return squared > 0 ? std::sqrt(squared) : 0;
}

/// From one zero of the free motion's velocity to the next [s]: half a period; infinite where it does not
/// swing.
inline double zero_spacing(const LinearLaw<double>& law) {
  const double w = damped_frequency(law);
  return w > 0 ? std::numbers::pi / w : std::numeric_limits<double>::infinity();
}

/// Impulse response of the linear law and what the free motion needs of it.
template <class Real>
struct ImpulseResponse {
  Real g;         // [s]
  Real slope;     // g'
  Real position;  // g' + 2 b g: the motion released at x = 1 from rest
};

/// cos(sqrt z) and sin(sqrt z)/sqrt z as power series, |z| <= 1: entire functions, so z may be zero or
/// negative.
template <class Real>
struct CosineSeries {
  Real cosine = 0, sinc = 0;

  explicit CosineSeries(const Real& z) {
    // The tenth term is below 1/20! = 4e-19.
    for (int n = 10; n > 0; --n) {
      cosine = (Real(1) + cosine) * (-z / Real((2 * n - 1) * (2 * n)));
      sinc = (Real(1) + sinc) * (-z / Real((2 * n) * (2 * n + 1)));
    }
    cosine = Real(1) + cosine;
    sinc = Real(1) + sinc;
  }
};

/// At any tau [s].
template <class Real>
ImpulseResponse<Real> impulse_response(const LinearLaw<Real>& law, const Real& tau) {
  using std::cos, std::exp, std::expm1, std::sin, std::sqrt;
  const Real b = law.decay_rate, s = law.stiffness;
  const Real discriminant = s - b * b;
  const double z = value_of(discriminant * tau * tau);
  if (z < -1) {
    // Real roots. The slow one as -s/(q + b): q - b would cancel. All sums below are of one sign wherever the
    // motion's are.
    const Real q = sqrt(-discriminant), r1 = -s / (q + b), r2 = -(q + b);
    const Real g = exp(r1 * tau) * -expm1(-(q + q) * tau) / (q + q);
    const Real fast = exp(r2 * tau);
    return {g, fast + r1 * g, fast - r2 * g};
  }
  const Real decay = exp(-b * tau);
  Real cosine, g;
  if (z <= 1) {
    const CosineSeries<Real> series(discriminant * tau * tau);
    cosine = decay * series.cosine;
    g = decay * series.sinc * tau;
  } else {
    const Real w = sqrt(discriminant);
    cosine = decay * cos(w * tau);
    g = decay * sin(w * tau) / w;
  }
  return {g, cosine - b * g, cosine + b * g};
}

/// (e^z - 1)/z for |z| <= 1/2.
template <class Real>
Complex<Real> exponential_quotient(const Complex<Real>& z) {
  const Complex<Real> one{Real(1), Real(0)};
  Complex<Real> sum = one;
  for (int n = 16; n > 1; --n) sum = one + Real(1.0 / n) * (z * sum);
  return sum;
}

/// P(tau), the response from rest to e^{i W u}, at any tau.
template <class Real>
Complex<Real> response_from_rest(const LinearLaw<Real>& law, const ImpulseResponse<Real>& free,
                                 const Real& tau) {
  using std::cos, std::sin, std::sqrt;
  const Real b = law.decay_rate, s = law.stiffness, w = law.drive_frequency;
  const double b_tau = value_of(b * tau), s_tau2 = value_of(s * tau * tau), w_tau = value_of(w * tau);

  if (std::abs(b_tau) <= 1 && std::abs(s_tau2) <= 1 && std::abs(w_tau) <= 1) {
    // All three nodes within reach of each other: the power series of the equation itself, p[n] the n-th
    // Taylor term of P:
    //   n (n - 1) p[n] = tau^2 (i W tau)^{n-2}/(n - 2)! - 2 b tau (n - 1) p[n-1] - s tau^2 p[n-2]
    Complex<Real> force{tau * tau, Real(0)}, before{}, last{}, sum{};
    for (int n = 2; n < 34; ++n) {
      const Complex<Real> next = Real(1.0 / (n * (n - 1))) *
                                 (force - (Real(2 * (n - 1)) * (b * tau)) * last - (s * tau * tau) * before);
      before = last;
      last = next;
      sum = sum + next;
      force = Real(1.0 / (n - 1)) * (Complex<Real>{Real(0), w * tau} * force);
    }
    return sum;
  }

  const Complex<Real> drive{cos(w * tau), sin(w * tau)};
  const Real discriminant = s - b * b;
  const bool oscillates = value_of(discriminant) > 0;
  // The root nearest to i W: the upper one, or the slow one of two real ones.
  const double root = std::sqrt(std::abs(value_of(discriminant)));
  const double off_re = oscillates ? value_of(b) : value_of(s) / (root + value_of(b));
  const double off_im = value_of(w) - (oscillates ? root : 0);
  if (std::hypot(off_re, off_im) * std::abs(value_of(tau)) < 0.25) {
    const Real q = sqrt(oscillates ? discriminant : -discriminant);
    const Complex<Real> nearest = oscillates ? Complex<Real>{-b, q} : Complex<Real>{-s / (q + b), Real(0)};
    const Complex<Real> other = oscillates ? Complex<Real>{-b, -q} : Complex<Real>{-(q + b), Real(0)};
    const Complex<Real> frequency{Real(0), w};
    // exp[i W, r1] = e^{i W tau} tau (e^d - 1)/d with d = (r1 - i W) tau
    const Complex<Real> pair = tau * (drive * exponential_quotient(tau * (nearest - frequency)));
    return (pair - Complex<Real>{free.g, Real(0)}) / (frequency - other);
  }
  const Complex<Real> inverse_response{s - w * w, Real(2) * b * w};
  return (drive - Complex<Real>{free.position, w * free.g}) / inverse_response;
}

/// The state at t of the motion through y0 at t0; t may lie before t0.
template <class Real>
State<Real> propagate(const LinearLaw<Real>& law, const Real& t0, const Real& t, const State<Real>& y0) {
  using std::cos, std::sin;
  const Real tau = t - t0;
  const ImpulseResponse<Real> free = impulse_response(law, tau);
  State<Real> y{free.position * y0.x + free.g * y0.v, free.slope * y0.v - law.stiffness * free.g * y0.x};
  if (law.drive_amplitude != Real(0)) {
    const Real phase = law.drive_frequency * t0 + law.drive_phase;
    const Complex<Real> start{law.drive_amplitude * cos(phase), law.drive_amplitude * sin(phase)};
    const Complex<Real> p = response_from_rest(law, free, tau);
    const Complex<Real> slope =
        Complex<Real>{free.g, Real(0)} + Complex<Real>{Real(0), law.drive_frequency} * p;
    y.x = y.x + (start * p).re;
    y.v = y.v + (start * slope).re;
  }
  return y;
}

// The motion under a force that begins as a constant or as a ramp:
//
//   step(tau) = integral from 0 to tau of g,  ramp(tau) = integral from 0 to tau of step,
//
// with the impulse response g. These are the divided differences of z -> e^{z tau} at 0, r1, r2 and at 0, 0,
// r1, r2. With g'' + 2 b g' + s g = 0 integrated once and twice,
//
//   s step = 1 - (g' + 2 b g),    s ramp = tau - g - 2 b step,
//
// which lose their digits where tau is short or a root is near 0. There the power series is used, or the
// difference of the two other nodes, which lie far apart. Every branch is smooth in b and s, so duals carry
// right derivatives. N. C. Nigam & P. C. Jennings, Bull. Seism. Soc. Am. 59, 909 (1969), give the formulas
// for the underdamped law only.
//
// Error: a few rounding errors, relative, of each.

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

/// At any tau >= 0 [s], given impulse_response(law, tau).
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
      // Looks at two in a row: without damping every second term is 0. The rest is too small to count.
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

/// The state a time tau after y0 under the force level + slope * u, u from 0 to tau, per unit mass. The
/// drive of the law is not used.
template <class Real>
State<Real> propagate_ramp(const LinearLaw<Real>& law, const Real& level, const Real& slope, const Real& tau,
                           const State<Real>& y0) {
  const ImpulseResponse<Real> free = impulse_response(law, tau);
  const RampResponse<Real> driven = ramp_response(law, free, tau);
  return {free.position * y0.x + free.g * y0.v + level * driven.step + slope * driven.ramp,
          free.slope * y0.v - law.stiffness * free.g * y0.x + level * free.g + slope * driven.step};
}

}  // namespace cromer::core
