#include "cromer/os/library.h"

#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

#include <system_error>

#include "cromer/os/windows/native.h"

namespace cromer::core::os {

void* load_library(const std::string& name, Symbols) { return ::LoadLibraryW(native(name).c_str()); }

std::string why_not_loaded() { return std::system_category().message(static_cast<int>(::GetLastError())); }

void* symbol_of(void* library, const char* name) {
  return reinterpret_cast<void*>(::GetProcAddress(static_cast<HMODULE>(library), name));
}

}  // namespace cromer::core::os
