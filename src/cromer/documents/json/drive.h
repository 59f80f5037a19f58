// What drives a simulated run, in its parameters.
#pragma once

#include "cromer/documents/json/json.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// Adds the drive's name and what it takes to the parameters of a run.
void add_drive(Json& parameters, const SimulatedRun& run, const SimulateOptions& options);

}  // namespace cromer::core
