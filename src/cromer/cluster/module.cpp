#include "cromer/cluster/module.h"

#include <dlfcn.h>
#include <fmt/format.h>

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
  std::string looked_in;
  for (const fs::path& folder : folders()) {
    const fs::path path = folder / module.file;
    std::error_code failed;
    if (!fs::exists(path, failed)) {
      looked_in += (looked_in.empty() ? "" : ", ") + folder.string();
      continue;
    }
    // Its symbols are everybody's: Open MPI loads parts of its own that look for them.
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (!library)
      return Error{fmt::format("{} need {}, which cannot be loaded: {}; install what {} brings", module.what,
                               path.string(), dlerror(), module.package)};
    if (void* function = dlsym(library, module.symbol)) return function;
    return Error{fmt::format("{} is not of this version of cromer; install both together", path.string())};
  }
  return Error{
      fmt::format("{} need {}, which is not there (looked in {}): this build came without; install {} "
                  "and build again, or set CROMER_MODULES to the folder that has it",
                  module.what, module.file, looked_in, module.package)};
}

}  // namespace cromer::core
