#include "cromer/cluster/module.h"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include "cromer/os/library.h"
#include "cromer/os/process.h"
#include "cromer/os/replacement.h"

namespace cromer::core {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> folders() {
  if (const char* asked = std::getenv("CROMER_MODULES"); asked && *asked) return {asked};
  const fs::path program = os::program().parent_path();
  const fs::path above = program.parent_path();
  return {program, above / CROMER_LIBDIR / "cromer", above / "lib", above};
}

constexpr std::size_t message_room = 512;

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
    case cromer_hdf5_system:
      return Notice{"hdf5_not_read", {{"why", std::strerror(std::atoi(message))}}};
    case cromer_hdf5_not_read:
      return Notice{"hdf5_not_read", {{"why", message}}};
  }
  return {};
}

}  // namespace

Result<void*> load_module(const Module& module) {
  std::vector<std::string> looked_in;
  for (const fs::path& folder : folders()) {
    const fs::path path = folder / module.file;
    std::error_code failed;
    if (!fs::exists(path, failed)) {
      looked_in.push_back(folder.string());
      continue;
    }
    // Its symbols are everybody's: Open MPI loads parts of its own that look for them.
    void* library = os::load_library(path.string(), os::Symbols::everybodys);
    if (!library)
      return Error{"module_not_loaded",
                   {{"what", module.what},
                    {"path", path.string()},
                    {"why", os::why_not_loaded()},
                    {"package", module.package}}};
    if (void* function = os::symbol_of(library, module.symbol)) return function;
    return Error{"module_of_other_version", {{"module", path.string()}}};
  }
  return Error{"module_not_there",
               {{"what", module.what},
                {"module", module.file},
                {"looked_in", looked_in},
                {"package", module.package}}};
}

Result<const CromerHdf5*> load_hdf5() {
  auto found = load_module({"libcromer_hdf5.so", "cromer_hdf5", Notice{"hdf5_files"}, "libhdf5-dev"});
  if (!found) return Error{"or_use_csv", {{"what", found.error().notice}}};
  const auto* module = reinterpret_cast<const CromerHdf5* (*)()>(*found)();
  if (module->version != hdf5_module_version)
    return Error{"module_of_other_version", {{"module", "libcromer_hdf5.so"}}};
  return module;
}

Result<void> create_hdf5(const CromerHdf5& module, const std::string& path, const std::string& name,
                         std::span<const CromerHdf5Text> texts, std::span<const CromerHdf5Group> groups,
                         std::span<CromerHdf5Dataset> datasets) {
  char message[message_room];
  const CromerHdf5End end =
      module.create(path.c_str(), texts.data(), texts.size(), groups.data(), groups.size(), datasets.data(),
                    datasets.size(), message, message_room);
  if (end == cromer_hdf5_good) return {};
  if (end == cromer_hdf5_system) return cannot_write(name, std::atoi(message));
  return Error{"cannot_write", {{"path", name}, {"why", hdf5_trouble(end, message)}}};
}

Notice read_hdf5(const CromerHdf5& module, const std::string& path, const CromerHdf5Reader& reader) {
  char message[message_room];
  const CromerHdf5End end = module.read(path.c_str(), &reader, message, message_room);
  return hdf5_trouble(end, message);
}

std::pair<std::string, std::string> name_and_unit(const std::string& column) {
  const auto open = column.find(" (");
  if (open == std::string::npos || column.back() != ')') return {column, "1"};
  return {column.substr(0, open), column.substr(open + 2, column.size() - open - 3)};
}

}  // namespace cromer::core
