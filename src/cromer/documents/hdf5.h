// Results as HDF5 files.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cromer/cluster/rows_file.h"
#include "cromer/cluster/tables_file.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

/// A group for each run, "run_1" and so on, with the kept states: t, x, v, energy and the simulated sensor.
std::vector<Hdf5Table> simulate_tables(const SimulateResult& result, const std::string& command);

/// One table: the axes damping_ratio (or loss_factor) and period, and over them the columns of the CSV file,
/// named with "_" for blanks.
std::vector<Hdf5Table> spectrum_tables(const SpectrumResult& result, const std::string& command);

/// A group for each motion that succeeded, "motion_1" and so on by its place, each as the table of
/// spectrum_tables with the names of its files.
std::vector<Hdf5Table> spectra_tables(std::span<const MotionSpectra> motions, const std::string& command);

/// Makes the file of a sweep; with `resume` opens the existing one.
Result<RowsFile> open_sweep_file(const SweepPlan& plan, const std::string& path, bool resume,
                                 const std::string& command, const Watch& watch);

/// Computes the chunks that are missing in the file. The result has the rows only if they fit in
/// `options.memory`. After an Error, finished chunks are still in the file.
Result<SweepResult> fill_sweep_file(RowsFile& file, SweepPlan plan, const SweepOptions& options,
                                    const ChunkMaker& make, const Watch& watch);

}  // namespace cromer::core
