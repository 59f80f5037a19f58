// How a computation is watched, how it ended and what it cost.
#pragma once

#include <functional>
#include <string_view>

namespace cromer {

/// Called up to twenty times a second with the share done, 0 to 1: from the calling thread or from one that
/// works for it, never from two at once. Returning false ends the work: what exists by then comes back, with
/// `interrupted` true. May be empty.
using Progress = std::function<bool(double done)>;

/// How a run ended.
enum class Status {
  reached_end,
  stopped_by_event,  ///< or its caller interrupted it
  step_limit,
  step_too_small,  ///< of an adaptive method: the motion runs away, or the tolerance asks for too much
  no_convergence,  ///< an implicit step found no solution
  not_finite       ///< the motion ran away
};

/// "reached_end", "stopped_by_event", ...
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

/// How a fit ended.
enum class FitStatus {
  converged,
  iteration_limit,  ///< not converged, or interrupted
  no_oscillation,
  too_short,    ///< fewer than one and a half periods, or too few samples
  too_noisy,    ///< the law accounts for too little, or the frequency is hardly known
  clipped,      ///< the tops of the motion are cut off
  overdamped,   ///< it comes to rest without oscillating
  undetermined  ///< of some parameters only a combination is known
};

/// "converged", "iteration_limit", ...
constexpr std::string_view name(FitStatus status) {
  switch (status) {
    case FitStatus::converged:
      return "converged";
    case FitStatus::iteration_limit:
      return "iteration_limit";
    case FitStatus::no_oscillation:
      return "no_oscillation";
    case FitStatus::too_short:
      return "too_short";
    case FitStatus::too_noisy:
      return "too_noisy";
    case FitStatus::clipped:
      return "clipped";
    case FitStatus::overdamped:
      return "overdamped";
    case FitStatus::undetermined:
      return "undetermined";
  }
  return "";
}

}  // namespace cromer
