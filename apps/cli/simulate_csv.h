// The states of simulated runs as CSV.
#pragma once

#include <string>

#include "commands.h"
#include "cromer/study/task/simulate.h"

namespace cromer::core::cli {

/// "run,t (s),x (m),v (m/s),energy (J)"; with a sensor what a logger would write, "Time (s),Position (m)",
/// several runs side by side. Comments at the head say where the numbers come from.
std::string simulate_csv(const SimulateResult& result, const Arguments& arguments);

}  // namespace cromer::core::cli
