// Parts of the program that are loaded only when they are needed: HDF5 and MPI take milliseconds to start.
#pragma once

#include <string>
#include <utility>

#include "cromer/cluster/hdf5_module.h"
#include "cromer/result.h"

namespace cromer::core {

/// A shared library of ours and what it takes to have it.
struct Module {
  const char* file;     ///< "libcromer_hdf5.so"
  const char* symbol;   ///< the function that gives its interface
  Notice what;          ///< what it is needed for: HDF5 files
  const char* package;  ///< what the build needs for it: "libhdf5-dev"
};

/// The address of the module's function. Looked for in the folder that CROMER_MODULES names, beside the
/// program, and in ../lib and the like beside that. An Error says where it was looked for and what to do.
Result<void*> load_module(const Module& module);

/// An Error where there is none says where it was looked for and what to do.
Result<const CromerHdf5*> load_hdf5();

/// What the module could not do, and HDF5's words for it; empty where all is good.
Notice hdf5_trouble(CromerHdf5End end, const char* message);

/// "amplitude (m)" is amplitude in m; what has no unit has "1".
std::pair<std::string, std::string> name_and_unit(const std::string& column);

}  // namespace cromer::core
