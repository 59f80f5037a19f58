// A free motion followed from sample to sample, its derivatives riding along; with dry friction in phases of
// slip and stick.
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
#include "cromer/methods/rk4.h"
#include "cromer/run/root.h"
#include "cromer/run/stick_slip.h"

namespace cromer {

/// A smooth system's motion.
template <class System, class Real>
class SmoothPhases {
 public:
  SmoothPhases(const System& system, const State<Real>& start) : system_(system), y_(start) {}

  void step(double t, double h) {
    auto memory = method_.start(system_, t, y_);
    y_ = method_.step(system_, t, h, y_, memory).y;
  }
  const State<Real>& state() const { return y_; }
  Real acceleration(double t) const { return system_.acceleration(t, y_.x, y_.v); }

 private:
  Rk4 method_;
  System system_;
  State<Real> y_;
};

/// The motion of a system with dry friction; `values` is the same system without derivatives.
template <class System, class Values, class Real>
class StickSlipPhases {
 public:
  StickSlipPhases(const System& system, const Values& values, const State<Real>& start)
      : system_(system), values_(values), y_(start) {
    const double v = value_of(y_.v);
    direction_ = v != 0 ? (v > 0 ? 1 : -1) : direction_from_rest(values_, 0, value_of(y_.x));
  }

  void step(double t, double h) {
    while (direction_ != 0 && h > 0) {
      const State<Real> end = moved(system_, t, h, y_);
      if (!(value_of(end.v) * direction_ < 0)) {
        y_ = end;
        return;
      }
      const State<double> from{value_of(y_.x), value_of(y_.v)};
      const auto velocity = [&](double by) { return moved(values_, t, by, from).v; };
      const double by =
          from.v == 0 ? 0 : std::clamp(find_root(velocity, 0, from.v, h, value_of(end.v)), 0.0, h);
      if (by > 0) y_ = moved(system_, t, by, y_);
      if (by > 0 || from.v != 0)
        turn(t + by);
      else
        rest();  // it was to slide on, and pull and friction cancel to rounding
      t += by;
      h -= by;
    }
  }
  const State<Real>& state() const { return y_; }
  Real acceleration(double t) const {
    return direction_ == 0 ? Real(0) : system_.sliding(direction_).acceleration(t, y_.x, y_.v);
  }

 private:
  template <class S, class R>
  State<R> moved(const S& system, double t, double h, const State<R>& y) const {
    const auto sliding = system.sliding(direction_);
    auto memory = method_.start(sliding, t, y);
    return method_.step(sliding, t, h, y, memory).y;
  }

  void rest() {
    direction_ = 0;
    y_.v = Real(0);
  }

  void turn(double t) {
    const double x = value_of(y_.x);
    const double before = values_.sliding(direction_).acceleration(t, x, 0.0);
    const int next = direction_from_rest(values_, t, x);
    if (next == 0) return rest();
    const double after = values_.sliding(next).acceleration(t, x, 0.0);
    direction_ = next;
    y_.v -= Real(value_of(y_.v));  // at rest to rounding
    if constexpr (requires { y_.v.derivative; })
      for (auto& derivative : y_.v.derivative) derivative *= before != 0 ? after / before : 0;
  }

  Rk4 method_;
  System system_;
  Values values_;
  State<Real> y_;
  int direction_ = 0;
};

/// Calls visit(i, phases) at every time, integrating in between in equal steps of at most h. Stops where the
/// state is no longer finite.
template <class Phases, class Visit>
void follow(Phases phases, std::span<const double> t, double h, Visit visit) {
  visit(std::size_t{0}, phases);
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double dt = t[i] - t[i - 1];
    const int steps = std::max(1, static_cast<int>(std::ceil(dt / h - 1e-9)));
    const double step = dt / steps;
    for (int n = 0; n < steps; ++n) phases.step(t[i - 1] + n * step, step);
    visit(i, phases);
    if (!std::isfinite(value_of(phases.state().x))) return;
  }
}

}  // namespace cromer
