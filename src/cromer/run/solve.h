// The loop: a method, step by step, from the start to the end of an interval.
//
// Law, method and loop are joined in two lines; the names are looked up once, inside there are direct
// calls:
//
//   KeepEvery keep(every, count_steps(interval, step));
//   Outcome outcome = with_terms(oscillator, drive, [&](const auto& system) {
//     return visit_method(name, settings, [&](const auto& method) { return solve(system, method, interval,
//     start, step, keep, watch); });
//   });
//   Trajectory trajectory = keep.take();
//
// The tasks do not: they call run_law (study/task/run_law.h), which has these lines compiled for all laws and
// methods once.
//
// Which loop that is, is decided here: uniform steps (the fast one), steps that are looked into for events,
// steps that the error estimate chooses; and with dry friction phases of either.
//
// The name must be in the list (check_method_name), a law without a closed form refused for `exact`
// (why_not_exact): a method that cannot integrate a system is a programmer's error.
#pragma once

#include <cassert>
#include <type_traits>
#include <utility>

#include "cromer/base/dual.h"
#include "cromer/base/interrupt.h"
#include "cromer/base/state.h"
#include "cromer/methods/method.h"
#include "cromer/run/adaptive_steps.h"
#include "cromer/run/course.h"
#include "cromer/run/event.h"
#include "cromer/run/fixed_steps.h"
#include "cromer/run/keep.h"
#include "cromer/run/outcome.h"
#include "cromer/run/step_control.h"
#include "cromer/run/stepper.h"
#include "cromer/run/steps.h"
#include "cromer/run/stick_slip.h"
#include "cromer/run/uniform_steps.h"

namespace cromer {

/// M can run S: with dry friction, the smooth systems of its phases.
template <class M, class S, class Real>
struct CanRun : std::bool_constant<Method<M, S, Real>> {};
template <class M, FrictionSystem S>
struct CanRun<M, S, double> : std::bool_constant<Method<M, SlidingSystem<S>, double>> {};

/// Runs method on system over the interval (until >= from) from the start state. The recorder is called with
/// (t, state) of the start and of every row, all finite: rows are `step` apart, row n at from + n step, the
/// last one at the end. A fixed-step method steps from row to row; an adaptive one chooses its own steps, by
/// the tolerance. An event that stops is recorded as the last row. Deterministic.
template <class S, class M, class Real, class Recorder>
requires(CanRun<M, S, Real>::value && !FrictionSystem<S>) Outcome
    solve(const S& system, const M& method, Interval interval, const State<Real>& start, StepControl control,
          Recorder&& record, const Watch& watch = {}, const Limits& limits = {},
          std::type_identity_t<EventLog*> events = nullptr) {
  const Lookout look{0, events};
  const auto one_by_one = [&](double t, const State<Real>& y) {
    record(t, y);
    pause(record);
  };
  if constexpr (AdaptiveMethod<M, S, Real>) {
    assert((std::is_same_v<Real, double> || !look.anything()) && "events are for doubles");
    const Rows rows{interval, control.step};
    Course<Real> course{interval.from, start};
    MotionScale scale;
    one_by_one(course.t, start);
    take_adaptive_steps(system, method, rows, control, look, scale, course, one_by_one, watch, limits);
    return course.outcome(rows, watch);
  } else {
    if constexpr (std::is_same_v<Real, double>) {
      if (look.anything()) {
        const Rows rows{interval, control.step};
        Course<double> course{interval.from, start};
        one_by_one(course.t, start);
        StepperOf stepper(system, method, course.t, course.y);
        take_fixed_steps(stepper, rows, look, course, one_by_one, watch, limits);
        return course.outcome(rows, watch);
      }
    }
    assert(!look.anything() && "events are for doubles");
    return take_uniform_steps(system, method, interval, start, control.step, record, watch, limits);
  }
}

/// The same with dry friction: phase by phase, each smooth. The moments where one ends are found to rounding
/// by the method's own partial steps, which keeps its order.
template <FrictionSystem S, class M, class Recorder>
requires(CanRun<M, S, double>::value) Outcome
    solve(const S& system, const M& method, Interval interval, const State<double>& start,
          StepControl control, Recorder&& record, const Watch& watch = {}, const Limits& limits = {},
          EventLog* events = nullptr) {
  const Rows rows{interval, control.step};
  Course<double> course{interval.from, start};
  MotionScale scale;
  const auto one_by_one = [&](double t, const State<double>& y) {
    record(t, y);
    pause(record);
  };
  one_by_one(course.t, start);
  const auto slide = [&](int direction) {
    const SlidingSystem<S> smooth = system.sliding(direction);
    const Lookout look{direction, events};
    if constexpr (AdaptiveMethod<M, SlidingSystem<S>, double>) {
      take_adaptive_steps(smooth, method, rows, control, look, scale, course, one_by_one, watch, limits);
    } else {
      StepperOf stepper(smooth, method, course.t, course.y);
      take_fixed_steps(stepper, rows, look, course, one_by_one, watch, limits);
    }
  };
  stick_and_slip(system, rows, course, slide, one_by_one, watch);
  return course.outcome(rows, watch);
}

/// A method that cannot integrate this system (`exact` and a law without a closed form): to be refused
/// before.
template <class S, class M, class Real, class Recorder>
requires(!CanRun<M, S, Real>::value) Outcome
    solve(const S&, const M&, Interval interval, const State<Real>& start, StepControl, Recorder&&,
          const Watch& = {}, const Limits& = {}, EventLog* = nullptr) {
  assert(false && "the method cannot integrate this system");
  Outcome outcome;
  outcome.status = Status::no_convergence;
  outcome.t = interval.from;
  outcome.y = {value_of(start.x), value_of(start.v)};
  return outcome;
}

}  // namespace cromer
