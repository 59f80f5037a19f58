#include "cromer/cluster/module.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

namespace cromer::core {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> folders() {
  if (const char* asked = std::getenv("CROMER_MODULES"); asked && *asked) return {asked};
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed).parent_path();
  const fs::path above = program.parent_path();
  return {program, above / CROMER_LIBDIR / "cromer", above / "lib", above};
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
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (!library)
      return Error{
          "module_not_loaded",
          {{"what", module.what}, {"path", path.string()}, {"why", dlerror()}, {"package", module.package}}};
    if (void* function = dlsym(library, module.symbol)) return function;
    return Error{"module_of_other_version", {{"module", path.string()}}};
  }
  return Error{"module_not_there",
               {{"what", module.what},
                {"module", module.file},
                {"looked_in", looked_in},
                {"package", module.package}}};
}

}  // namespace cromer::core
