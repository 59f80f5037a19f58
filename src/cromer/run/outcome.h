// How a run ended and what it cost.
#pragma once

#include "cromer/base/state.h"
#include "cromer/status.h"

namespace cromer::core {

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

}  // namespace cromer::core
