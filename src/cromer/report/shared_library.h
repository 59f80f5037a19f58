// C functions of libraries that need not be there: looked up when they are needed.
#pragma once

#include <dlfcn.h>

namespace cromer::core {

/// Sets `function` to the library's function of that name; false where either is missing, dlerror() then says
/// why. The library stays loaded.
template <class Function>
bool find_function(const char* library, const char* name, Function*& function) {
  void* const loaded = dlopen(library, RTLD_NOW);
  function = loaded ? reinterpret_cast<Function*>(dlsym(loaded, name)) : nullptr;
  return function != nullptr;
}

}  // namespace cromer::core
