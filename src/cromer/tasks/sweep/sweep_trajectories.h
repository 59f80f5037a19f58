// The motion of every point of a sweep that runs to an end, thinned: one point after the other, so that a
// sweep of any length takes the memory of a block of states.
#pragma once

#include <cstdint>
#include <vector>

#include "cromer/base/function_ref.h"
#include "cromer/base/interrupt.h"
#include "cromer/result.h"
#include "cromer/tasks/sweep/sweep.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// About how many states that will be: the first and every Nth of each point, every > 0. Of more than 10000
/// points some are looked at for all. An adaptive method counts as if it took the step of the others. An
/// Error where the sweep looks for settled motion, which has no end.
Result<double> count_trajectory_states(const SweepPlan& plan, long long every);

/// Takes the next states of the point with these values of the swept options, in order; at most 4096 at once.
using TrajectorySink = FunctionRef<Result<void>(const std::vector<double>& values, const Trajectory& states)>;

struct SweptTrajectories {
  std::uint64_t points = 0;  ///< that came to their end
  std::uint64_t failed = 0;  ///< that ran away, or found no solution: what came before is there
  bool interrupted = false;
};

/// Point by point in the order of the rows. An Error of the sink ends it.
Result<SweptTrajectories> run_trajectories(const SweepPlan& plan, long long every, const TrajectorySink& sink,
                                           const Watch& watch);

}  // namespace cromer::core
