// What the loops that take one step at a time share: the rows to record, and where a run stands.
#pragma once

#include <limits>

#include "cromer/base/dual.h"
#include "cromer/base/interrupt.h"
#include "cromer/base/state.h"
#include "cromer/run/outcome.h"
#include "cromer/run/steps.h"

namespace cromer::core {

/// Times no further apart than this part of a step are the same.
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
  double last_step = 0;  // [s] of the controller, where a phase ended in full swing; else 0
  Counts counts{};

  /// Not at the end, nor ended early.
  bool goes_on(const Rows& rows) const { return status == Status::reached_end && row < rows.last(); }

  /// Looks at interrupt and limit, and tells the progress, every hundred steps or so.
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
