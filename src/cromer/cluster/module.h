// Parts of the program that are loaded only when they are needed, since HDF5 and MPI take milliseconds to
// start.
#pragma once

#include <span>
#include <string>
#include <utility>

#include "cromer/cluster/hdf5_module.h"
#include "cromer/result.h"

namespace cromer::core {

/// A shared library of Cromer, and what is needed to have it.
struct Module {
  const char* file;     ///< "libcromer_hdf5.so"
  const char* symbol;   ///< the function that gives its interface
  Notice what;          ///< what it is needed for: HDF5 files
  const char* package;  ///< what the build needs for it: "libhdf5-dev"
};

/// The address of the module's function. Looked for in the folder that CROMER_MODULES names, beside the
/// program, and in ../lib and the like beside that. An Error says where it was looked for and what to do.
Result<void*> load_module(const Module& module);

/// The HDF5 module. If there is none, the Error says where it was looked for and what to do.
Result<const CromerHdf5*> load_hdf5();

/// The module's `create`. Messages call the file `name`.
Result<void> create_hdf5(const CromerHdf5& module, const std::string& path, const std::string& name,
                         std::span<const CromerHdf5Text> texts, std::span<const CromerHdf5Group> groups,
                         std::span<CromerHdf5Dataset> datasets);

/// The module's `read`. Returns what it could not do, with HDF5's words for it; empty if all is good.
Notice read_hdf5(const CromerHdf5& module, const std::string& path, const CromerHdf5Reader& reader);

/// Name and unit of a column: "amplitude (m)" is amplitude in m; without a unit it is "1".
std::pair<std::string, std::string> name_and_unit(const std::string& column);

}  // namespace cromer::core
