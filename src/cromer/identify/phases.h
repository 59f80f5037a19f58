// A free motion followed through the times of a record, its derivatives riding along; with dry friction in
// phases of slip and stick.
//
// Steps of dormand-prince are as long as the accuracy asks for, whatever the sampling: between their ends
// stands the polynomial of fifth degree through displacement, velocity and acceleration at both, within
// (w h)^6/46000 of the amplitude.
//
// A phase of slip ends where the velocity vanishes, at a moment that depends on the parameters. The step is
// cut there, at a fixed time, and the state goes over to the next phase: the displacement keeps its
// derivatives, since at rest a shift of the moment moves nothing; the velocity's are multiplied by the
// acceleration after the moment over that before it. I. A. Hiskens & M. A. Pai, IEEE Trans. Circuits Syst. I
// 47, 204 (2000).
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "cromer/base/dual.h"
#include "cromer/base/state.h"
#include "cromer/methods/dormand_prince.h"
#include "cromer/run/root.h"
#include "cromer/run/stick_slip.h"

namespace cromer {

/// Hermite's polynomial of fifth degree over a step of h [s] at its fraction s.
template <class Real>
Real displacement_within(const DormandPrince::Memory<Real>& step, double h, double s) {
  const double s3 = s * s * s, rest = 1 - s, rest3 = rest * rest * rest;
  const double x1 = s3 * (10 + s * (6 * s - 15)), x0 = 1 - x1;
  const double v0 = h * s * rest3 * (1 + 3 * s), v1 = -h * s3 * rest * (4 - 3 * s);
  const double a0 = 0.5 * h * h * s * s * rest3, a1 = 0.5 * h * h * s3 * rest * rest;
  return x0 * step.from.x + x1 * step.to.x + v0 * step.from.v + v1 * step.to.v + a0 * step.acceleration_from +
         a1 * step.acceleration_to;
}

/// Its derivative.
template <class Real>
Real velocity_within(const DormandPrince::Memory<Real>& step, double h, double s) {
  const double s2 = s * s, rest = 1 - s, rest2 = rest * rest;
  const double x = 30 * s2 * rest2 / h;
  const double v0 = rest2 * (1 + 2 * s - 15 * s2), v1 = s2 * (-12 + s * (28 - 15 * s));
  const double a0 = 0.5 * h * s * rest2 * (2 - 5 * s), a1 = 0.5 * h * s2 * rest * (3 - 5 * s);
  return x * (step.to.x - step.from.x) + v0 * step.from.v + v1 * step.to.v + a0 * step.acceleration_from +
         a1 * step.acceleration_to;
}

/// A smooth system's motion. step(t, h) takes a step of h and returns its length; last() are its ends,
/// direction() is the sign of the velocity between them, 0 at rest.
template <class System, class Real>
class SmoothPhases {
 public:
  SmoothPhases(const System& system, const State<Real>& start)
      : system_(system), last_(method_.start(system, 0.0, start)) {}

  double step(double t, double h) {
    method_.step(system_, t, h, last_.to, last_);
    return h;
  }
  const DormandPrince::Memory<Real>& last() const { return last_; }
  int direction() const { return value_of(last_.from.v + last_.to.v) < 0 ? -1 : 1; }
  Real acceleration(double t, const Real& x, const Real& v) const { return system_.acceleration(t, x, v); }

 private:
  DormandPrince method_;
  System system_;
  DormandPrince::Memory<Real> last_;
};

/// The motion of a system with dry friction; `values` is the same system without derivatives. A step ends at
/// the latest where the velocity vanishes.
template <class System, class Values, class Real>
class StickSlipPhases {
 public:
  StickSlipPhases(const System& system, const Values& values, const State<Real>& start)
      : system_(system), values_(values), y_(start) {
    const double v = value_of(y_.v);
    begin(v != 0 ? (v > 0 ? 1 : -1) : direction_from_rest(values_, 0, value_of(y_.x)));
  }

  double step(double t, double h) {
    if (turning_) turn(t);
    direction_ = next_;
    if (direction_ == 0) return h;
    const DormandPrince::Memory<Real> before = last_;
    method_.step(system_.sliding(direction_), t, h, y_, last_);
    const double v = value_of(y_.v), end = value_of(last_.to.v);
    turning_ = end * direction_ < 0;
    if (turning_ && v == 0) {  // it was to slide on, and pull and friction cancel to rounding
      begin(0);
      direction_ = 0;
      return h;
    }
    if (turning_) {
      const auto sliding = values_.sliding(direction_);
      const State<double> from{value_of(y_.x), v};
      const auto velocity = [&](double by) {
        auto memory = method_.start(sliding, t, from);
        return method_.step(sliding, t, by, from, memory).y.v;
      };
      h = std::clamp(find_root(velocity, 0, v, h, end), 1e-12 * h, h);
      last_ = before;
      method_.step(system_.sliding(direction_), t, h, y_, last_);
    }
    y_ = last_.to;
    return h;
  }
  const DormandPrince::Memory<Real>& last() const { return last_; }
  int direction() const { return direction_; }
  Real acceleration(double t, const Real& x, const Real& v) const {
    return direction_ == 0 ? Real(0) : system_.sliding(direction_).acceleration(t, x, v);
  }

 private:
  // The next phase: from y_, 0 to stick.
  void begin(int direction) {
    turning_ = false;
    direction_ = next_ = direction;
    if (direction == 0) y_.v = Real(0);
    last_ = {y_, y_, Real(0), Real(0), {}, 0.0};
    if (direction != 0) last_ = method_.start(system_.sliding(direction), 0.0, y_);
  }

  void turn(double t) {
    const double x = value_of(y_.x);
    const double before = values_.sliding(direction_).acceleration(t, x, 0.0);
    const int next = direction_from_rest(values_, t, x);
    if (next != 0) {
      const double after = values_.sliding(next).acceleration(t, x, 0.0);
      y_.v -= Real(value_of(y_.v));  // at rest to rounding
      if constexpr (requires { y_.v.derivative; })
        for (auto& derivative : y_.v.derivative) derivative *= before != 0 ? after / before : 0;
    }
    begin(next);
  }

  DormandPrince method_;
  System system_;
  Values values_;
  State<Real> y_;
  DormandPrince::Memory<Real> last_{};
  int direction_ = 0;     // of the step that last() shows
  int next_ = 0;          // of the next one
  bool turning_ = false;  // at the end of that step
};

/// A motion at a time within its last step.
template <class Phases>
class Seen {
 public:
  Seen(const Phases& phases, double t, double length, double share)
      : phases_(phases), t_(t), length_(length), share_(share) {}

  int direction() const { return phases_.direction(); }
  auto x() const {
    return phases_.direction() == 0 ? phases_.last().to.x
                                    : displacement_within(phases_.last(), length_, share_);
  }
  auto v() const { return velocity_within(phases_.last(), length_, share_); }
  auto a() const { return phases_.acceleration(t_, x(), v()); }

 private:
  const Phases& phases_;
  double t_, length_, share_;
};

/// Calls visit(i, seen) at every time, strictly increasing, in steps of at most h. Stops where the motion is
/// no longer finite.
template <class Phases, class Visit>
void follow(Phases phases, std::span<const double> t, double h, Visit visit) {
  double now = t.front();
  for (std::size_t i = 0; i < t.size();) {
    const double length = phases.step(now, h);
    for (; i < t.size() && t[i] <= now + length; ++i) {
      const double share = (t[i] - now) / length;
      visit(i, Seen<Phases>(phases, t[i], length, share));
    }
    if (!std::isfinite(value_of(phases.last().to.x))) return;
    now += length;
  }
}

}  // namespace cromer
