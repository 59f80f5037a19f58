// A spectrum as an HDF5 file.
#pragma once

#include <string>
#include <vector>

#include "cromer/cluster/tables_file.h"
#include "cromer/tasks/spectrum/response_spectrum.h"

namespace cromer::core {

/// One table: the axes damping_ratio (or loss_factor) and period, and over them what the CSV has, names with
/// "_" for blanks.
std::vector<Hdf5Table> spectrum_tables(const SpectrumResult& result, const std::string& command);

}  // namespace cromer::core
