// What one interval of a recording does to the linear law: the exact recurrence of N. C. Nigam & P. C.
// Jennings, Bull. Seism. Soc. Am. 59, 909 (1969), from the closed forms of the model.
#pragma once

#include "cromer/base/state.h"
#include "cromer/model/propagate.h"

namespace cromer::core {

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

}  // namespace cromer::core
