// --trajectories of a sweep: the motion of every point in one CSV, written as it comes.
#pragma once

#include <string>

#include "cromer/base/interrupt.h"
#include "cromer/result.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core::cli {

struct TrajectoryOptions {
  std::string path{};   ///< FILE.csv; "" none
  long long every = 1;  ///< keep every Nth state, > 0
};

/// Asked before the sweep: that it can be written, and has room. Says how large it will be.
Result<std::string> announce_trajectories(const SweepPlan& plan, const TrajectoryOptions& options);

/// Columns: the swept options, t, x and v; rows in the order of the sweep's. What there is to say is
/// returned: points that ran away, or an interruption, after which what came before it is in the file.
Result<std::string> write_trajectories(const SweepPlan& plan, const TrajectoryOptions& options,
                                       const std::string& command, const Watch& watch);

}  // namespace cromer::core::cli
