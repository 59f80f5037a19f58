// What drives a simulated run, in its parameters.
#pragma once

#include "cromer/study/json/json.h"
#include "cromer/study/task/simulate.h"

namespace cromer::core {

/// Adds the drive's name and what it takes to the parameters of a run.
void add_drive(Json& parameters, const SimulatedRun& run, const SimulateOptions& options);

}  // namespace cromer::core
