#include "cromer/run/fixed_steps.h"

#include <algorithm>

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

void take_fixed_steps(Stepper& stepper, const Rows& rows, const Lookout& look, Course<double>& course,
                      AnyRecorder record, const Watch& watch, const Limits& limits, double phase_end) {
  take_searched_steps(stepper, rows, look, course, record, watch, limits, phase_end);
}

}  // namespace cromer::core
