// Steps whose length the error estimate chooses; rows by dense output.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "cromer/base/compensated.h"
#include "cromer/base/interrupt.h"
#include "cromer/base/state.h"
#include "cromer/methods/method.h"
#include "cromer/run/course.h"
#include "cromer/run/event.h"
#include "cromer/run/step_control.h"

namespace cromer::core {

/// A system for steps of any length, one after another: its own form that is ready at the method's nodes, if
/// system and method have that, else the system itself.
template <class S, class M>
class ReadyForSteps {
 public:
  explicit ReadyForSteps(const S& system) : system_(system) {}
  const S& over(double, double) { return system_; }

 private:
  const S& system_;
};

template <class S, class M>
requires requires(const S& system) { system.template on_nodes<M>().move_to(0.0, 1.0); }
class ReadyForSteps<S, M> {
 public:
  explicit ReadyForSteps(const S& system) : ready_(system.template on_nodes<M>()) {}

  /// For the step from t to t + h [s].
  const auto& over(double t, double h) {
    ready_.move_to(t, h);
    return ready_;
  }

 private:
  decltype(std::declval<const S&>().template on_nodes<M>()) ready_;
};

/// Whether the error of a step from t to t + h is the rounding of the acceleration, where the system says how
/// large that is [m/s^2]: forces that all but cancel, or a drive that has hardly begun, set a motion going so
/// gently that nothing else is seen.
template <class S, class Real>
bool is_rounding(const S& system, const Trial<Real>& trial, double t, double h) {
  if constexpr (requires { system.acceleration_rounding(t); }) {
    const double change = 4 * system.acceleration_rounding(t) * h;  // [m/s]
    return std::abs(value_of(trial.error.v)) <= change && std::abs(value_of(trial.error.x)) <= change * h;
  }
  return false;
}

/// Goes on from where the course stands until the last row, the end of the phase (rest, or phase_end [s]), or
/// an early end. The error of each step is at most the tolerance, relative to the motion's own scale
/// (MotionScale). Status step_too_small where that would take steps that time cannot resolve. Steps are
/// searched where the lookout is one for this kind of number.
template <class S, class M, class Look, class Real, class Recorder>
requires AdaptiveMethod<M, S, Real>
void take_adaptive_steps(const S& system, const M& method, const Rows& rows, const StepControl& control,
                         const Look& look, MotionScale& scale, Course<Real>& course, const Recorder& record,
                         const Watch& watch, const Limits& limits,
                         double phase_end = std::numeric_limits<double>::infinity()) {
  constexpr int parts = 8;  // a long step may pass a threshold more than once
  auto memory = method.start(system, course.t, course.y);
  course.at_rest = false;
  course.counts.evaluations += 2;  // at the start, and for the first step
  scale.include(course.y);
  const double end = std::min(rows.time(rows.last()), phase_end);
  PiController controller(M::info.error_order);
  double h = course.last_step;
  if (!(h > 0))
    h = first_step(course.y, system.acceleration(course.t, course.y.x, course.y.v), control.tolerance,
                   M::info.error_order, rows.step);
  course.last_step = 0;
  ReadyForSteps<S, M> ready(system);
  // Equal steps would round the same way each time: the rest is kept.
  Compensated now(course.t);
  while (course.goes_on(rows) && !course.at_rest && course.t < end) {
    course.look_up(rows, watch, limits);
    if (course.status != Status::reached_end) return;
    // What would be left for one more step is shared between two.
    const double left = end - course.t, wanted = h;
    const bool last = h >= left * (1 - 1e-12);
    if (last)
      h = left;
    else if (2 * h > left)
      h = left / 2;

    auto tried = memory;
    const Trial<Real> trial = method.step(ready.over(course.t, h), course.t, h, course.y, tried);
    course.counts.newton_iterations += trial.newton_iterations;
    course.counts.evaluations += M::info.evaluations_of(1, trial.newton_iterations);
    const bool finite = is_finite(trial.y);
    double error = std::numeric_limits<double>::infinity();
    if (trial.converged && finite)
      error = is_rounding(system, trial, course.t, h) ? 0 : scale.norm(trial, h, control.tolerance);
    if (!(error <= 1)) {
      ++course.counts.rejected;
      h *= controller.after_rejected(error);
      if (h < 16 * std::numeric_limits<double>::epsilon() * std::abs(course.t) || !(h > 0))
        course.status = !trial.converged ? Status::no_convergence
                        : !finite        ? Status::not_finite
                                         : Status::step_too_small;
      continue;
    }

    const double t = course.t;
    CutOf<Real> cut;
    if constexpr (std::is_same_v<Real, typename Look::Number>) {
      if (look.anything()) {
        const auto exactly = [&](double theta) {
          auto copy = memory;
          course.counts.evaluations += M::info.evaluations;
          return one_step(system, method, t, theta * h, course.y, copy).y;
        };
        cut = look_inside(look, t, h, course.y, trial.y, parts, method.dense_output(tried), exactly);
      }
    }
    ++course.counts.accepted;
    const bool whole = cut.theta == 1;
    if (whole)
      now += h;
    else
      now += cut.theta * h;
    const double until = whole && last ? end : value_of(now);
    if (course.row < rows.last() && rows.time(course.row + 1) < until) {
      const auto inside = method.dense_output(tried);
      for (; course.row < rows.last() && rows.time(course.row + 1) < until; ++course.row) {
        const double at = rows.time(course.row + 1);
        record(at, inside(std::max(0.0, (at - t) / h)));
      }
    }
    course.t = until;
    if constexpr (std::is_same_v<Real, typename Look::Number>)
      course.y = look.anything() ? cut.y : trial.y;
    else
      course.y = trial.y;
    course.at_rest = cut.at_rest;
    if (cut.stopped) course.status = Status::stopped_by_event;
    const bool on_row = course.row < rows.last() && rows.time(course.row + 1) == until;
    if (on_row) ++course.row;
    if (on_row || cut.stopped) record(course.t, course.y);
    memory = tried;
    scale.include(course.y);
    // Where nothing has moved, a long step could leap over what will set it going.
    const double factor = controller.after_accepted(error);
    if (factor != 1) h = error > 0 ? h * factor : std::max(h, std::min(h * factor, rows.step));
    if (last && !course.at_rest) course.last_step = std::max(h, wanted);
  }
}

}  // namespace cromer::core
