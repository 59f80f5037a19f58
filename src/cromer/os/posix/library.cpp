#include "cromer/os/library.h"

#include <dlfcn.h>

namespace cromer::core::os {

void* load_library(const std::string& name, Symbols symbols) {
  return ::dlopen(name.c_str(), RTLD_NOW | (symbols == Symbols::everybodys ? RTLD_GLOBAL : 0));
}

std::string why_not_loaded() {
  const char* const why = ::dlerror();
  return why ? why : "";
}

void* symbol_of(void* library, const char* name) { return ::dlsym(library, name); }

}  // namespace cromer::core::os
