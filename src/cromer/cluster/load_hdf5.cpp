#include "cromer/cluster/load_hdf5.h"

#include "cromer/cluster/module.h"

namespace cromer::core {

Result<const CromerHdf5*> load_hdf5() {
  auto found = load_module({"libcromer_hdf5.so", "cromer_hdf5", Notice{"hdf5_files"}, "libhdf5-dev"});
  if (!found) return Error{"or_use_csv", {{"what", found.error().notice}}};
  const auto* module = reinterpret_cast<const CromerHdf5* (*)()>(*found)();
  if (module->version != hdf5_module_version)
    return Error{"module_of_other_version", {{"module", "libcromer_hdf5.so"}}};
  return module;
}

Notice hdf5_trouble(CromerHdf5End end, const char* message) {
  switch (end) {
    case cromer_hdf5_good:
      break;
    case cromer_hdf5_not_made:
      return Notice{"hdf5_not_made", {{"why", message}}};
    case cromer_hdf5_part:
      return Notice{"hdf5_part_not_made", {{"why", message}}};
    case cromer_hdf5_not_written:
      return Notice{"hdf5_not_written", {{"why", message}}};
    case cromer_hdf5_not_opened:
      return Notice{"hdf5_not_opened", {{"why", message}}};
    case cromer_hdf5_not_read:
      return Notice{"hdf5_not_read", {{"why", message}}};
  }
  return {};
}

std::pair<std::string, std::string> name_and_unit(const std::string& column) {
  const auto open = column.find(" (");
  if (open == std::string::npos || column.back() != ')') return {column, "1"};
  return {column.substr(0, open), column.substr(open + 2, column.size() - open - 3)};
}

}  // namespace cromer::core
