// A motion followed through the times of a record, its derivatives riding along; with dry friction in phases
// of slip and stick.
//
// Free and harmonically driven motions go in steps of dormand-prince as long as the accuracy asks for,
// whatever the sampling: between their ends stands the polynomial of fifth degree through displacement,
// velocity and acceleration at both, within (w h)^6/46000 of the amplitude. Under a recorded force, which has
// corners at its samples, they go from sample to sample by rk4.
//
// A phase of slip ends where the velocity vanishes, at a moment that depends on the parameters. The step is
// cut there, at a fixed time, and the state goes over to the next phase: the displacement keeps its
// derivatives, since at rest a shift of the moment moves nothing; the velocity's are multiplied by the
// acceleration after the moment over that before it. I. A. Hiskens & M. A. Pai, IEEE Trans. Circuits Syst. I
// 47, 204 (2000). A body that sticks breaks loose where the pull exceeds the friction: it starts with no
// acceleration, so that a shift of that moment moves nothing either.
#pragma once

#include <algorithm>
#include <cmath>

#include "cromer/base/state.h"
#include "cromer/identify/motion/motion_system.h"
#include "cromer/methods/dormand_prince.h"
#include "cromer/methods/rk4.h"
#include "cromer/run/root.h"

namespace cromer::core {

/// The number that a record sees, of a motion with or without an inner state.
template <std::size_t N>
Dual<double, N>& observable(Dual<double, N>& x) {
  return x;
}
template <std::size_t N>
const Dual<double, N>& observable(const Dual<double, N>& x) {
  return x;
}
template <std::size_t N>
Dual<double, N>& observable(Coupled<Dual<double, N>>& x) {
  return x.first;
}
template <std::size_t N>
const Dual<double, N>& observable(const Coupled<Dual<double, N>>& x) {
  return x.first;
}

/// The last step of a method without an interpolant.
template <class Real>
struct PlainStep {
  State<Real> from, to;
};

/// What the last step of a method leaves to be looked at.
template <class Real, class Method>
struct StepOf {
  using Type = PlainStep<Real>;
};
template <class Real>
struct StepOf<Real, DormandPrince> {
  using Type = DormandPrince::Memory<Real>;
};

/// Steps of a method: start(...) at a state, step(...) on from where `last` ends.
template <class System, class Method>
class PathStepper {
 public:
  using Real = typename System::Real;
  using Step = typename StepOf<Real, Method>::Type;

  static Step start(const System& system, double t, const State<Real>& y) {
    if constexpr (std::is_same_v<Method, DormandPrince>)
      return Method{}.start(system, t, y);
    else
      return {y, y};
  }
  // Flat: what the method tells of its error, which nobody asks for, is then not computed. The page is small.
#ifndef CROMER_PAGE
  [[gnu::flatten, gnu::noinline]]
#endif
  static void
  step(const System& system, double t, double h, Step& last) {
    const State<Real> y = last.to;
    if constexpr (std::is_same_v<Method, DormandPrince>) {
      const auto drive = system.drive().in_step(t, h);
      Method{}.step(system.under(drive), t, h, y, last);
    } else {
      NoMemory none;
      last = {y, Method{}.step(system, t, h, y, none).y};
    }
  }
};

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

/// The motion from its start. step(t, h) takes a step of at most h and returns its length; direction() is the
/// sign of the velocity in it, 0 at rest.
template <class Code, class Method>
class Path {
 public:
  using System = MotionSystem<Code>;
  using Real = typename System::Real;
  using Number = typename System::Number;
  using Steps = PathStepper<System, Method>;
  using Step = typename Steps::Step;

  Path(const Motion& motion, const typename Code::Drive& drive) : motion_(motion), system_(motion, drive) {
    State<Real> y{};
    observable(y.x).value = motion.position;
    observable(y.v).value = motion.velocity;
    if constexpr (Code::columns > 0) {
      observable(y.x).derivative[Code::position_column] = 1;
      observable(y.v).derivative[Code::velocity_column] = 1;
    }
    last_.to = y;
    started_ = false;
  }

  double step(double t, double h) {
    if (!started_) begin(t, has_friction() ? direction_at(t, last_.to) : 0);
    if constexpr (Code::has_friction)
      if (has_friction()) return phase(t, h);
    Steps::step(system_, t, h, last_);
    return h;
  }

  const Step& last() const { return last_; }
  int direction() const {
    if (has_friction()) return direction_;
    return observable(last_.from.v).value + observable(last_.to.v).value < 0 ? -1 : 1;
  }
  bool sticks() const { return has_friction() && direction_ == 0; }
  /// [unit/s^2] of a state in the last step.
  Number acceleration(double t, const Real& x, const Real& v) const {
    if (sticks()) return Number(0.0);
    const auto a = system_.acceleration(t, x, v);
    return observable(a);
  }

 private:
  // Code that many laws share is made for friction too.
  bool has_friction() const { return Code::has_friction && motion_.law.has<Friction>(); }
  // What friction must balance to hold it [unit/s^2].
  double pull(double t, const State<Real>& y) const {
    const auto a = system_.sliding(0).acceleration(t, y.x, y.v);
    return observable(a).value;
  }
  int direction_at(double t, const State<Real>& y) const {
    if (const double v = observable(y.v).value; v != 0) return v > 0 ? 1 : -1;
    const double a = pull(t, y);
    return std::abs(a) > motion_.per_mass.friction ? (a > 0 ? 1 : -1) : 0;
  }

  // A phase from last_.to, 0 to stick.
  void begin(double t, int direction) {
    started_ = true;
    turning_ = false;
    direction_ = next_ = direction;
    State<Real> y = last_.to;
    if (has_friction() && direction == 0) observable(y.v) = Number(0.0);
    system_ = system_.sliding(direction);
    last_ = Steps::start(system_, t, y);
    if (has_friction() && direction == 0) hold(y);
  }

  void hold(const State<Real>& y) {
    if constexpr (std::is_same_v<Method, DormandPrince>)
      last_ = {y, y, Real(0), Real(0), {}, 0.0};
    else
      last_ = {y, y};
  }

  double phase(double t, double h) {
    if (turning_)
      turn(t);
    else if (next_ != direction_)
      begin(t, next_);
    return direction_ == 0 ? stick(t, h) : slide(t, h);
  }

  double slide(double t, double h) {
    const Step before = last_;
    const double v = observable(before.to.v).value;
    Steps::step(system_, t, h, last_);
    const double end = observable(last_.to.v).value;
    turning_ = end * direction_ < 0;
    if (!turning_) return h;
    if (v == 0) {  // it was to slide on, and pull and friction cancel to rounding
      last_ = before;
      begin(t, 0);
      return h;
    }
    // The moment is looked for without derivatives.
    const PlainSystem plain = PlainSystem(motion_, system_.drive()).sliding(direction_);
    const auto started = PathStepper<PlainSystem, Method>::start(plain, t, plain_state(before.to));
    const auto velocity = [&](double by) {
      auto trial = started;
      PathStepper<PlainSystem, Method>::step(plain, t, by, trial);
      return observable(trial.to.v).value;
    };
    h = std::clamp(find_root(velocity, 0, v, h, end), 1e-12 * h, h);
    last_ = before;
    Steps::step(system_, t, h, last_);
    return h;
  }

  using PlainSystem = MotionSystem<MotionCode<Code::code, typename Code::Drive, false>>;
  static State<typename PlainSystem::Real> plain_state(const State<Real>& y) {
    State<typename PlainSystem::Real> plain{};
    observable(plain.x).value = observable(y.x).value;
    observable(plain.v).value = observable(y.v).value;
    if constexpr (Code::hysteretic) plain.v.second.value = y.v.second.value;
    return plain;
  }

  // The velocity vanishes.
  void turn(double t) {
    State<Real>& y = last_.to;
    observable(y.v).value = 0;  // at rest to rounding
    const auto going = system_.acceleration(t, y.x, y.v);
    const double before = observable(going).value;
    const int next = direction_at(t, y);
    if (next != 0) {
      const auto gone = system_.sliding(next).acceleration(t, y.x, y.v);
      const double after = observable(gone).value;
      for (auto& derivative : observable(y.v).derivative) derivative *= before != 0 ? after / before : 0;
    }
    begin(t, next);
  }

  // At rest for h, or until the pull exceeds the friction.
  double stick(double t, double h) {
    hold(last_.to);
    if constexpr (Code::Drive::count > 0) {
      const double friction = motion_.per_mass.friction;
      const auto excess = [&](double by) { return std::abs(pull(t + by, last_.to)) - friction; };
      constexpr int looks = 4;  // in a step
      double from = 0, at_from = excess(0);
      for (int i = 1; i <= looks; ++i) {
        const double by = h * i / looks, at = excess(by);
        if (at > 0) {
          const double loose = at_from < 0 ? find_root(excess, from, at_from, by, at) : from;
          next_ = pull(t + by, last_.to) > 0 ? 1 : -1;
          if (loose > 0) return loose;
          begin(t, next_);
          return slide(t, h);
        }
        from = by, at_from = at;
      }
    }
    return h;
  }

  const Motion& motion_;
  System system_;
  Step last_{};
  int direction_ = 0;  // of the last step
  int next_ = 0;       // of the next one
  bool started_ = false;
  bool turning_ = false;  // at the end of the last step
};

}  // namespace cromer::core
