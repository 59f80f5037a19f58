// A spectrum as an HDF5 file.
#pragma once

#include "command_line.h"
#include "cromer/cluster/tables_file.h"
#include "cromer/study/task/response_spectrum.h"

namespace cromer::core::cli {

/// One table: the axes damping_ratio (or loss_factor) and period, and over them what the CSV has, names with
/// "_" for blanks.
std::vector<Hdf5Table> spectrum_tables(const SpectrumResult& result, const Arguments& arguments);

}  // namespace cromer::core::cli
