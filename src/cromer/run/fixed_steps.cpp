#include "cromer/run/fixed_steps.h"

#include <algorithm>
#include <cmath>

namespace cromer::core {

Outcome walk_in_blocks(Interval interval, double step, int block, const Tally& tally,
                       FunctionRef<Status(long long first, long long last)> steps,
                       FunctionRef<Status(double t, double h)> last_step, const Watch& watch,
                       const Limits& limits) {
  const Steps all = count_steps(interval, step);
  const long long whole = std::min(all.whole, limits.steps);
  Outcome outcome;
  Status& status = outcome.status;
  for (long long n = 0; n < whole && status == Status::reached_end; n += block) {
    if (watch.interrupted()) {
      outcome.interrupted = true;
      status = Status::stopped_by_event;
      break;
    }
    if (watch.progress && n % (64LL * block) == 0)
      watch.progress(static_cast<double>(n) / static_cast<double>(all.count()));
    status = steps(n, std::min(n + block, whole));
  }
  outcome.t = interval.from + static_cast<double>(tally.accepted) * step;
  if (status == Status::reached_end && whole < all.count()) {
    if (whole == limits.steps) {
      status = Status::step_limit;
    } else if (status = last_step(outcome.t, all.last); status == Status::reached_end) {
      outcome.last_step = all.last;
      outcome.t += all.last;
    }
  }
  if (status == Status::reached_end && watch.progress) watch.progress(1.0);
  outcome.step = tally.accepted;
  outcome.counts.accepted = tally.accepted;
  outcome.counts.newton_iterations = tally.newton_iterations;
  return outcome;
}

namespace {

/// Into how many parts a step must be divided so that no two zeros of the velocity fall into one. The first
/// zero ends the phase, so that many parts cost nothing.
long long parts_of_step(const Stepper& stepper, double h) {
  return static_cast<long long>(std::min(1e15, 1 + std::floor(1.01 * h / stepper.zero_spacing())));
}

}  // namespace

void take_fixed_steps(Stepper& stepper, const Rows& rows, const Lookout& look, Course<double>& course,
                      AnyRecorder record, const Watch& watch, const Limits& limits, double phase_end) {
  const auto count = [&](const Trial<double>& trial) {
    course.counts.newton_iterations += trial.newton_iterations;
    course.counts.evaluations += stepper.info().evaluations_of(1, trial.newton_iterations);
    return trial;
  };
  course.at_rest = false;
  // An end that is a row but for rounding is that row.
  const double soon = phase_end - same_time * rows.step;
  while (course.goes_on(rows) && !course.at_rest && course.t < soon) {
    course.look_up(rows, watch, limits);
    if (course.status != Status::reached_end) return;
    const bool to_row = rows.time(course.row + 1) <= phase_end + same_time * rows.step;
    const double next = to_row ? rows.time(course.row + 1) : phase_end;
    const double h = to_row && course.t == rows.time(course.row) ? rows.spacing(course.row) : next - course.t;
    if (!(h > 0)) {  // a phase ended just on the row
      ++course.row;
      record(course.t, course.y);
      continue;
    }
    const Trial<double> trial = count(stepper.step(course.t, h, course.y));
    if (!trial.converged) {
      course.status = Status::no_convergence;
      return;
    }
    if (!is_finite(trial.y)) {
      course.status = Status::not_finite;
      return;
    }
    const auto partly = [&](double theta) { return count(stepper.part(course.t, theta * h, course.y)).y; };
    const Cut cut =
        look_inside(look, course.t, h, course.y, trial.y, parts_of_step(stepper, h), partly, partly);
    ++course.counts.accepted;
    const bool whole = cut.theta == 1;
    course.t = whole ? next : course.t + cut.theta * h;
    course.y = cut.y;
    course.at_rest = cut.at_rest;
    if (cut.stopped) course.status = Status::stopped_by_event;
    if (whole && to_row) ++course.row;
    if ((whole && to_row) || cut.stopped) record(course.t, course.y);
  }
}

}  // namespace cromer::core
