// The states of simulated runs as CSV.
#pragma once

#include <string>

#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// "run,t (s),x (m),v (m/s),energy (J)"; with a sensor what a logger would write, "Time (s),Position (m)",
/// several runs side by side. Comments at the head say where the numbers come from, unless
/// `command` is empty.
std::string simulate_csv(const SimulateResult& result, const std::string& command);

}  // namespace cromer::core
