// Sweeps as CSV: the rows, and the motions of their points.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cromer/tasks/sweep/sweep.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// The swept options, then the measures; one row for each point. What made it stands in comments at the head,
/// unless `command` is empty.
std::string sweep_csv(const SweepResult& result, const std::string& command);

/// The swept options, t, x and v: a block of states of the point with these values. The header and the
/// comments come before the first block.
void append_trajectory(std::string& out, const SweepPlan& plan, const std::vector<double>& values,
                       const Trajectory& states, std::span<const std::string> comments, bool first);

}  // namespace cromer::core
