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
// The tasks do not: they call run_law (tasks/simulate/run_law.h), which has these lines compiled for all laws
// and methods once.
//
// The loop is chosen here: uniform steps (the fast loop), steps that are searched for events, or steps that
// the error estimate chooses; with dry friction, phases of either.
//
// The name must be in the list (check_method_name), a law without a closed form refused for `exact`
// (why_not_exact): a method that cannot integrate a system is a programmer's error.
#pragma once

#include <cassert>
#include <concepts>
#include <limits>
#include <type_traits>

#include "cromer/base/dual.h"
#include "cromer/base/interrupt.h"
#include "cromer/base/state.h"
#include "cromer/methods/method.h"
#include "cromer/run/adaptive_steps.h"
#include "cromer/run/course.h"
#include "cromer/run/event.h"
#include "cromer/run/fixed_steps.h"
#include "cromer/run/keep.h"
#include "cromer/run/step_control.h"
#include "cromer/run/stick_slip.h"

namespace cromer::core {

/// M can run S: with dry friction, the smooth systems of its phases.
template <class M, class S, class Real>
struct CanRun : std::bool_constant<Method<M, S, Real>> {};
template <class M, FrictionSystem S>
struct CanRun<M, S, double> : std::bool_constant<Method<M, SlidingSystem<S>, double>> {};

/// A system whose drive jumps or bends: next_break(t) is the first time after t at which it does, within(t)
/// the smooth system that holds from t until then (of a drive that ends, itself without one).
template <class S>
concept SystemWithBreaks = requires(const S& system, double t) {
  { system.next_break(t) } -> std::convertible_to<double>;
  { system.within(t) } -> std::same_as<S>;
};

/// Whether a run by M in steps of this length meets breaks inside its steps. A closed form knows them.
template <class M, class S>
bool has_breaks_within_steps(const S& system, Interval interval, double step) {
  if constexpr (SystemWithBreaks<S> && !M::info.is_exact())
    return !(interval.from == 0 && system.is_smooth_in_steps(step)) &&
           system.next_break(interval.from - step) < interval.until;
  return false;
}

/// Calls piece(smooth, end) for each smooth stretch of the system from where the course stands: methods and
/// their error estimates expect a smooth law, so that every step ends at a break at the latest. A system
/// without breaks is one stretch.
template <class S, class Real, class Piece>
void for_each_stretch(const S& system, const Rows& rows, Course<Real>& course, const Piece& piece) {
  if constexpr (SystemWithBreaks<S>) {
    const double ahead = 2 * same_time * rows.step;  // a row that is a break but for rounding
    while (course.goes_on(rows)) {
      const S smooth = system.within(course.t + ahead);
      piece(smooth, system.next_break(course.t + ahead));
    }
  } else {
    piece(system, std::numeric_limits<double>::infinity());
  }
}

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
  assert((std::is_same_v<Real, double> || !look.anything()) && "events are for doubles");
  if constexpr (AdaptiveMethod<M, S, Real>) {
    const Rows rows{interval, control.step};
    Course<Real> course{interval.from, start};
    MotionScale scale;
    one_by_one(course.t, start);
    for_each_stretch(system, rows, course, [&](const S& smooth, double end) {
      take_adaptive_steps(smooth, method, rows, control, look, scale, course, one_by_one, watch, limits, end);
    });
    return course.outcome(rows, watch);
  } else {
    if constexpr (std::is_same_v<Real, double> || SystemWithBreaks<S>) {
      if (look.anything() || has_breaks_within_steps<M>(system, interval, control.step)) {
        const Rows rows{interval, control.step};
        Course<Real> course{interval.from, start};
        one_by_one(course.t, start);
        const auto run = [&](const S& smooth, double end) {
          StepperOf stepper(smooth, method, course.t, course.y);
          if constexpr (std::is_same_v<Real, double>)
            take_fixed_steps(stepper, rows, look, course, one_by_one, watch, limits, end);
          else
            take_searched_steps(stepper, rows, look, course, one_by_one, watch, limits, end);
        };
        if constexpr (M::info.is_exact())
          run(system, std::numeric_limits<double>::infinity());
        else
          for_each_stretch(system, rows, course, run);
        return course.outcome(rows, watch);
      }
    }
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
  // From break to break: a slide that a break cuts goes on after it.
  const auto slide_within = [&](const S& piece, int direction, double end) {
    const SlidingSystem<S> smooth = piece.sliding(direction);
    const Lookout look{direction, events};
    if constexpr (AdaptiveMethod<M, SlidingSystem<S>, double>) {
      take_adaptive_steps(smooth, method, rows, control, look, scale, course, one_by_one, watch, limits, end);
    } else {
      StepperOf stepper(smooth, method, course.t, course.y);
      take_fixed_steps(stepper, rows, look, course, one_by_one, watch, limits, end);
    }
  };
  const auto slide = [&](int direction) {
    if constexpr (SystemWithBreaks<S>) {
      const double ahead = course.t + 2 * same_time * rows.step;
      slide_within(system.within(ahead), direction, system.next_break(ahead));
    } else {
      slide_within(system, direction, std::numeric_limits<double>::infinity());
    }
  };
  stick_and_slip(system, rows, course, slide, one_by_one, watch);
  return course.outcome(rows, watch);
}

/// For a method that cannot integrate this system (`exact` and a law without a closed form), which callers
/// must refuse.
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

}  // namespace cromer::core
