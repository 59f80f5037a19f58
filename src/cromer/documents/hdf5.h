// Results as HDF5 files.
#pragma once

#include <string>
#include <vector>

#include "cromer/cluster/rows_file.h"
#include "cromer/cluster/tables_file.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

/// A group for each run, "run_1" and so on: t, x, v and energy at the kept states, and what a sensor read.
std::vector<Hdf5Table> simulate_tables(const SimulateResult& result, const std::string& command);

/// One table: the axes damping_ratio (or loss_factor) and period, and over them what the CSV has, names with
/// "_" for blanks.
std::vector<Hdf5Table> spectrum_tables(const SpectrumResult& result, const std::string& command);

/// Lays the file out, or with `resume` opens what there is.
Result<RowsFile> open_sweep_file(const SweepPlan& plan, const std::string& path, bool resume,
                                 const std::string& command, const Watch& watch);

/// Makes what the file lacks. The result has the rows where they fit in memory, else none. An Error comes
/// with what is finished kept in the file.
Result<SweepResult> fill_sweep_file(RowsFile& file, SweepPlan plan, const SweepOptions& options,
                                    const ChunkMaker& make, const Watch& watch);

}  // namespace cromer::core
