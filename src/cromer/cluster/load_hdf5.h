// The HDF5 module, loaded when it is first asked for.
#pragma once

#include <string>
#include <utility>

#include "cromer/cluster/hdf5_module.h"
#include "cromer/result.h"

namespace cromer::core {

/// An Error where there is none says where it was looked for and what to do.
Result<const CromerHdf5*> load_hdf5();

/// What the module could not do, and HDF5's words for it; empty where all is good.
Notice hdf5_trouble(CromerHdf5End end, const char* message);

/// "amplitude (m)" is amplitude in m; what has no unit has "1".
std::pair<std::string, std::string> name_and_unit(const std::string& column);

}  // namespace cromer::core
