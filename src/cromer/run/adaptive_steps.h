// Steps whose length the error estimate chooses; rows by dense output.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "cromer/base/interrupt.h"
#include "cromer/base/state.h"
#include "cromer/methods/method.h"
#include "cromer/run/course.h"
#include "cromer/run/look_inside.h"
#include "cromer/run/step_control.h"

namespace cromer {

/// Goes on from where the course stands until the last row, the end of the phase, or an early end. The error
/// of each step is at most the tolerance, relative to the motion's own scale (MotionScale). Status
/// step_too_small where that would take steps that time cannot resolve.
template <class S, class M, class Real, class Recorder>
requires AdaptiveMethod<M, S, Real>
void take_adaptive_steps(const S& system, const M& method, const Rows& rows, const StepControl& control,
                         const Lookout& look, MotionScale& scale, Course<Real>& course, Recorder& record,
                         const Watch& watch, const Limits& limits) {
  constexpr int parts = 8;  // a long step may pass a threshold more than once
  auto memory = method.start(system, course.t, course.y);
  course.at_rest = false;
  course.counts.evaluations += 2;  // at the start, and for the first step
  scale.include(course.y);
  const double end = rows.time(rows.last());
  PiController controller(M::info.error_order);
  double h = first_step(course.y, system.acceleration(course.t, course.y.x, course.y.v), control.tolerance,
                        M::info.error_order, rows.step);
  while (course.goes_on(rows) && !course.at_rest) {
    course.look_up(rows, watch, limits);
    if (course.status != Status::reached_end) return;
    // What would be left for one more step is shared between two.
    const double left = end - course.t;
    h = std::min(h, control.longest);
    const bool last = h >= left * (1 - 1e-12);
    if (last)
      h = left;
    else if (2 * h > left)
      h = left / 2;

    auto tried = memory;
    const Trial<Real> trial = method.step(system, course.t, h, course.y, tried);
    course.counts.newton_iterations += trial.newton_iterations;
    course.counts.evaluations += M::info.evaluations_of(1, trial.newton_iterations);
    const bool finite = is_finite(trial.y);
    const double error = trial.converged && finite ? scale.norm(trial, h, control.tolerance)
                                                   : std::numeric_limits<double>::infinity();
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
    const auto inside = [&](double theta) { return method.interpolate(tried, theta); };
    Cut cut;
    if constexpr (std::is_same_v<Real, double>) {
      if (look.anything()) {
        const auto exactly = [&](double theta) {
          auto copy = memory;
          course.counts.evaluations += M::info.evaluations;
          return method.step(system, t, theta * h, course.y, copy).y;
        };
        cut = look_inside(look, t, h, course.y, trial.y, parts, inside, exactly);
      }
    }
    ++course.counts.accepted;
    const bool whole = cut.theta == 1;
    const double until = whole ? (last ? end : t + h) : t + cut.theta * h;
    for (; course.row < rows.last() && rows.time(course.row + 1) < until; ++course.row) {
      const double at = rows.time(course.row + 1);
      record(at, inside(std::max(0.0, (at - t) / h)));
    }
    course.t = until;
    if constexpr (std::is_same_v<Real, double>)
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
    h = error > 0 ? h * factor : std::max(h, std::min(h * factor, rows.step));
  }
}

}  // namespace cromer
