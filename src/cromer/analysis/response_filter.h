// The linear law from sample to sample of a recorded drive: the exact recurrence, and the same as a filter,
// the form in which many oscillators at once are best walked.
#pragma once

#include "cromer/base/state.h"
#include "cromer/model/propagate.h"

namespace cromer::core {

// What one interval of a recording does: the recurrence of N. C. Nigam & P. C. Jennings, Bull. Seism. Soc.
// Am. 59, 909 (1969), from the closed forms of the model.

/// y(h) = A y(0) + from f(0) + to f(h), f the force per unit mass at the ends of the interval: a ramp
/// between them, or f(0) throughout where it is held.
template <class Real>
struct IntervalMap {
  Real xx, xv, vx, vv;         // A: of x on x [1], of v on x [s], of x on v [1/s], of v on v [1]
  State<Real> from, to;        // [s^2], [s] of the force at the two ends
  Real x_lost, v_lost;         ///< 1 - xx and 1 - vv, which would cancel in a short interval
  Real decay_rate, stiffness;  // of the law: b [1/s], s [1/s^2] > 0

  State<Real> operator()(const State<Real>& y, const Real& f0, const Real& f1) const {
    return {xx * y.x + xv * y.v + from.x * f0 + to.x * f1, vx * y.x + vv * y.v + from.v * f0 + to.v * f1};
  }
};

/// Of an interval h > 0 [s]; the drive of the law is not looked at. Error: a few rounding errors, relative,
/// of every coefficient.
template <class Real>
IntervalMap<Real> interval_map(const LinearLaw<Real>& law, const Real& h, bool hold) {
  const ImpulseResponse<Real> free = impulse_response(law, h);
  const RampResponse<Real> driven = ramp_response(law, free, h);
  const Real b = law.decay_rate, s = law.stiffness;
  const State<Real> step{driven.step, free.g};
  const State<Real> to = hold ? State<Real>{Real(0), Real(0)} : State<Real>{driven.ramp / h, driven.step / h};
  const Real x_lost = s * driven.step;
  return {.xx = free.position,
          .xv = free.g,
          .vx = -s * free.g,
          .vv = free.slope,
          .from = {step.x - to.x, step.v - to.v},
          .to = to,
          .x_lost = x_lost,
          .v_lost = x_lost + Real(2) * b * free.g,
          .decay_rate = b,
          .stiffness = s};
}

// The filter. With f the force at the samples, a quantity q = p x + r v of the motion is a filter of second
// order,
//
//   q_n = (n0 + n1/z + n2/z^2)/(1 - tr(A)/z + det(A)/z^2) f_n.
//
// Its denominator written as u_n - 2 u_{n-1} + u_{n-2} and what is left over gives a step like
// Euler-Cromer's,
//
//   d_n = det(A) d_{n-1} - kappa u_{n-1} + f_n,   u_n = u_{n-1} + d_n,   kappa = det(I - A),
//   q_n = gain (u_{n-1} + e0 d_n + e2 d_{n-1}),
//
// seven operations with the range of q. Directly, 1 - tr(A)/z + det(A)/z^2 would lose its digits as (w h)^-2;
// here kappa is a sum of positive terms, u carries the motion and d its increments, and none are lost.

/// A quantity that is read off the state: position and velocity, weighted.
template <class Real>
struct ResponseQuantity {
  Real x;  ///< weight of the position
  Real v;  ///< weight of the velocity
};

/// Between two steps: sum and last increment.
template <class Real>
struct FilterState {
  Real u, d;
};

template <class Real>
struct ResponseFilter {
  Real decay;   ///< det(A) = e^{-2 b h}
  Real kappa;   ///< det(I - A), about (w h)^2
  Real e0, e2;  ///< weights of the increments
  Real gain;    ///< q over what step() returns

  /// Takes the force at the next sample; returns q there, over the gain.
  template <class Force>
  Real step(FilterState<Real>& y, const Force& f) const {
    const Real d = (f - kappa * y.u) + decay * y.d;
    const Real q = (y.u + e2 * y.d) + e0 * d;
    y.u = y.u + d;
    y.d = d;
    return q;
  }
};

/// How the state of the filter and that of the motion belong together: after the sample n the motion arrives
/// at the sample n + 1 with of_u u + of_d d + to f_{n+1}.
template <class Real>
struct FilterToMotion {
  State<Real> of_u, of_d;

  State<Real> next(const FilterState<Real>& y, const IntervalMap<Real>& map, const Real& f) const {
    return {of_u.x * y.u + of_d.x * y.d + map.to.x * f, of_u.v * y.u + of_d.v * y.d + map.to.v * f};
  }
};

/// of_u = (I - adj A) G, of_d = adj(A) G, G = A to + from.
template <class Real>
FilterToMotion<Real> filter_to_motion(const IntervalMap<Real>& m) {
  const State<Real> g = {m.xx * m.to.x + m.xv * m.to.v + m.from.x, m.vx * m.to.x + m.vv * m.to.v + m.from.v};
  return {{m.v_lost * g.x + m.xv * g.v, m.vx * g.x + m.x_lost * g.v},
          {m.vv * g.x - m.xv * g.v, m.xx * g.v - m.vx * g.x}};
}

/// The state of the filter while the motion is at rest under the force f, about to go on from there. For
/// intervals of less than half a period: at whole halves the force alone cannot bring a motion to rest.
template <class Real>
FilterState<Real> at_rest(const IntervalMap<Real>& m, const Real& f) {
  const FilterToMotion<Real> motion = filter_to_motion(m);
  const Real x = m.from.x * f, v = m.from.v * f;
  const Real determinant = motion.of_u.x * motion.of_d.v - motion.of_d.x * motion.of_u.v;
  return {(x * motion.of_d.v - motion.of_d.x * v) / determinant,
          (motion.of_u.x * v - x * motion.of_u.v) / determinant};
}

/// `quantity.x` not 0.
template <class Real>
ResponseFilter<Real> response_filter(const IntervalMap<Real>& m, const ResponseQuantity<Real>& quantity) {
  const Real kappa = m.x_lost * m.v_lost - m.xv * m.vx;
  const Real gain = quantity.x * kappa / m.stiffness;
  const Real n0 = quantity.x * m.to.x + quantity.v * m.to.v;
  const Real n2 =
      (quantity.v * m.vx - quantity.x * m.vv) * m.from.x + (quantity.x * m.xv - quantity.v * m.xx) * m.from.v;
  return {m.xx * m.vv - m.xv * m.vx, kappa, n0 / gain, -n2 / gain, gain};
}

}  // namespace cromer::core
