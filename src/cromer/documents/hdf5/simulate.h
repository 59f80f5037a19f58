// Simulated runs as an HDF5 file.
#pragma once

#include <string>
#include <vector>

#include "cromer/cluster/tables_file.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// A group for each run, "run_1" and so on: t, x, v and energy at the kept states, and what a sensor read.
std::vector<Hdf5Table> simulate_tables(const SimulateResult& result, const std::string& command);

}  // namespace cromer::core
