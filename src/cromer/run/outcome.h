// How a run ended and what it cost.
#pragma once

#include <string_view>

#include "cromer/base/state.h"

namespace cromer {

enum class Status { reached_end, stopped_by_event, step_limit, step_too_small, no_convergence, not_finite };

/// The name as the contract writes it: "reached_end".
constexpr std::string_view name(Status status) {
  switch (status) {
    case Status::reached_end:
      return "reached_end";
    case Status::stopped_by_event:
      return "stopped_by_event";
    case Status::step_limit:
      return "step_limit";
    case Status::step_too_small:
      return "step_too_small";
    case Status::no_convergence:
      return "no_convergence";
    case Status::not_finite:
      return "not_finite";
  }
  return "";
}

struct Counts {
  long long accepted = 0;           ///< steps taken
  long long rejected = 0;           ///< steps tried and thrown away (adaptive methods)
  long long evaluations = 0;        ///< of the acceleration
  long long newton_iterations = 0;  ///< over all steps; 0 for explicit methods

  friend bool operator==(const Counts&, const Counts&) = default;
};

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

}  // namespace cromer
