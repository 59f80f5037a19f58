// Steps of fixed length that are looked into: with events, or while a mass slides with dry friction.
#pragma once

#include <algorithm>
#include <cmath>

#include "cromer/base/interrupt.h"
#include "cromer/base/state.h"
#include "cromer/methods/method.h"
#include "cromer/run/course.h"
#include "cromer/run/look_inside.h"

namespace cromer {

/// Into how many parts a step must be divided so that no two zeros of the velocity fall into one; 1 where the
/// system does not say how close they are (then the step is the caller's choice).
template <class S>
long long parts_of_step(const S& system, double h) {
  // The first zero ends the phase, so that many parts cost nothing.
  if constexpr (requires { system.zero_spacing(); })
    return static_cast<long long>(std::min(1e15, 1 + std::floor(1.01 * h / system.zero_spacing())));
  return 1;
}

/// Goes on from where the course stands, from row to row, until the last one, the end of the phase, or an
/// early end. A phase that begins between two rows first makes a shorter step to the next: a method's partial
/// step is as good as its step, so phases and events keep its order.
template <class S, class M, class Recorder>
requires Method<M, S, double>
void take_fixed_steps(const S& system, const M& method, const Rows& rows, const Lookout& look,
                      Course<double>& course, Recorder& record, const Watch& watch, const Limits& limits) {
  auto memory = method.start(system, course.t, course.y);
  course.at_rest = false;
  while (course.goes_on(rows) && !course.at_rest) {
    course.look_up(rows, watch, limits);
    if (course.status != Status::reached_end) return;
    const double next = rows.time(course.row + 1);
    const double h = course.t == rows.time(course.row) ? rows.spacing(course.row) : next - course.t;
    if (!(h > 0)) {  // a phase ended just on the row
      ++course.row;
      record(course.t, course.y);
      continue;
    }
    const auto before = memory;
    const auto step = [&](double length, auto& from) {
      const Trial<double> trial = method.step(system, course.t, length, course.y, from);
      course.counts.newton_iterations += trial.newton_iterations;
      course.counts.evaluations += M::info.evaluations_of(1, trial.newton_iterations);
      return trial;
    };
    const Trial<double> trial = step(h, memory);
    if (!trial.converged) {
      course.status = Status::no_convergence;
      return;
    }
    if (!is_finite(trial.y)) {
      course.status = Status::not_finite;
      return;
    }
    const auto partly = [&](double theta) {
      auto copy = before;
      return step(theta * h, copy).y;
    };
    const Cut cut =
        look_inside(look, course.t, h, course.y, trial.y, parts_of_step(system, h), partly, partly);
    ++course.counts.accepted;
    const bool whole = cut.theta == 1;
    course.t = whole ? next : course.t + cut.theta * h;
    course.y = cut.y;
    course.at_rest = cut.at_rest;
    if (cut.stopped) course.status = Status::stopped_by_event;
    if (whole) ++course.row;
    if (whole || cut.stopped) record(course.t, course.y);
  }
}

}  // namespace cromer
