// A run from its interval to its outcome: the steps and rows it takes, where it stands, how it ended.
#pragma once

#include <cmath>
#include <limits>

#include "cromer/base/dual.h"
#include "cromer/base/interrupt.h"
#include "cromer/base/state.h"
#include "cromer/status.h"

namespace cromer::core {

/// From the first to the last time of a run.
struct Interval {
  double from = 0;   // [s]
  double until = 0;  // [s] >= from
};

/// Whole steps, and the shorter one that ends the run where they do not fill the interval.
struct Steps {
  long long whole = 0;
  double last = 0;  // [s] 0 if there is no shorter one

  long long count() const { return whole + (last > 0); }
};

/// An interval that is a whole number of steps to 1e-9 of a step has no shorter one. step [s] > 0. Beyond
/// 2^53 steps, where times can no longer be told apart, the count saturates.
inline Steps count_steps(Interval interval, double step) {
  constexpr double largest = 9007199254740992.0;  // 2^53
  const double steps = (interval.until - interval.from) / step;
  if (!(steps > 0)) return {};
  if (steps >= largest) return {.whole = static_cast<long long>(largest)};
  // Many steps carry the rounding of the quotient itself.
  const double slack = std::fmax(1e-9, 4 * std::numeric_limits<double>::epsilon() * steps);
  const double nearest = std::round(steps);
  if (std::abs(steps - nearest) <= slack && nearest > 0) return {.whole = static_cast<long long>(nearest)};
  const double whole = std::floor(steps);
  return {.whole = static_cast<long long>(whole), .last = interval.until - (interval.from + whole * step)};
}

/// States 0, every, 2 every, ... of the run, for every >= 1. Each takes 24 bytes in a Trajectory.
inline long long number_of_kept_states(Steps steps, long long every) { return steps.count() / every + 1; }

/// The last good state, where it was reached, and why the run ended there.
struct Outcome {
  Status status = Status::reached_end;
  double t = 0;              // [s] of the last good state
  State<double> y{};         // the last good state; always finite
  long long step = 0;        ///< number of the last good step; the next one failed unless the end was reached
  bool interrupted = false;  ///< the caller asked for it (then status is stopped_by_event)
  double last_step =
      0;  // [s] of the shorter step that ended the run; 0 if `until` was a whole number of steps
  Counts counts;
};

/// Times no further apart than this fraction of a step count as the same.
inline constexpr double same_time = 1e-9;

/// When to give up.
struct Limits {
  long long steps = std::numeric_limits<long long>::max();  ///< > 0; where more are needed the run ends with
                                                            ///< Status::step_limit
};

/// The times at which states are recorded: row n at from + n step, never accumulated, and the end.
struct Rows {
  Interval interval;
  double step;  // [s]
  Steps steps = count_steps(interval, step);

  long long last() const { return steps.count(); }
  double time(long long n) const {
    return n <= steps.whole ? interval.from + static_cast<double>(n) * step
                            : interval.from + static_cast<double>(steps.whole) * step + steps.last;
  }
  /// From row n to the next.
  double spacing(long long n) const { return n < steps.whole ? step : steps.last; }
};

/// Where a run stands.
template <class Real>
struct Course {
  double t;  // [s]
  State<Real> y;
  long long row = 0;  ///< the last one recorded
  Status status = Status::reached_end;
  bool interrupted = false;
  bool at_rest = false;  ///< a sliding mass has stopped: the next phase begins
  double cut_after = 0;  // [s] into the last step, and what was left of it
  double cut_before = 0;
  double last_step = 0;  // [s] the step that the controller wanted where a phase ended in full swing; else 0
  Counts counts{};

  /// Not at the end, nor ended early.
  bool goes_on(const Rows& rows) const { return status == Status::reached_end && row < rows.last(); }

  /// Checks the step limit. Every hundred steps or so it also checks the interrupt; more rarely it tells the
  /// progress.
  void look_up(const Rows& rows, const Watch& watch, const Limits& limits) {
    const long long steps = counts.accepted + counts.rejected;
    if (counts.accepted >= limits.steps) status = Status::step_limit;
    if (steps % 128 != 0) return;
    if (watch.interrupted()) {
      interrupted = true;
      status = Status::stopped_by_event;
    }
    if (watch.progress && steps % 8192 == 0)
      watch.progress(static_cast<double>(row) / static_cast<double>(rows.last()));
  }

  Outcome outcome(const Rows& rows, const Watch& watch) const {
    Outcome outcome;
    outcome.status = status;
    outcome.t = t;
    outcome.y = {value_of(y.x), value_of(y.v)};
    outcome.step = counts.accepted;
    outcome.interrupted = interrupted;
    outcome.last_step = status == Status::reached_end ? rows.steps.last : 0;
    outcome.counts = counts;
    if (status == Status::reached_end && watch.progress) watch.progress(1.0);
    return outcome;
  }
};

/// True if both are numbers.
template <class Real>
bool is_finite(const State<Real>& y) {
  // One comparison for both: the difference of infinities is infinite or NaN, and neither compares.
  return std::abs(value_of(y.x) - value_of(y.v)) <= std::numeric_limits<double>::max();
}

}  // namespace cromer::core
