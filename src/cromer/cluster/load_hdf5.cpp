#include "cromer/cluster/load_hdf5.h"

#include "cromer/cluster/module.h"

namespace cromer::core {

Result<const CromerHdf5*> load_hdf5() {
  auto found = load_module({"libcromer_hdf5.so", "cromer_hdf5", "HDF5 files", "libhdf5-dev"});
  if (!found) return Error{found.error().message + "; or use -o FILE.csv"};
  const auto* module = reinterpret_cast<const CromerHdf5* (*)()>(*found)();
  if (module->version != hdf5_module_version)
    return Error{"libcromer_hdf5.so is not of this version of cromer; install both together"};
  return module;
}

std::pair<std::string, std::string> name_and_unit(const std::string& column) {
  const auto open = column.find(" (");
  if (open == std::string::npos || column.back() != ')') return {column, "1"};
  return {column.substr(0, open), column.substr(open + 2, column.size() - open - 3)};
}

}  // namespace cromer::core
