// Simulated runs as an HDF5 file.
#pragma once

#include "command_line.h"
#include "cromer/cluster/tables_file.h"
#include "cromer/study/task/simulate.h"

namespace cromer::core::cli {

/// A group for each run, "run_1" and so on: t, x, v and energy at the kept states, and what a sensor read.
std::vector<Hdf5Table> simulate_tables(const SimulateResult& result, const Arguments& arguments);

}  // namespace cromer::core::cli
