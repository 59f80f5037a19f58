// What Windows calls things: paths in UTF-16, handles for descriptors.
#pragma once

#include <io.h>

#include <filesystem>
#include <string>

namespace cromer::core::os {

inline std::filesystem::path native(const std::string& path) {
  return std::filesystem::path(std::u8string(path.begin(), path.end()));
}

/// A HANDLE.
inline void* handle_of(int descriptor) { return reinterpret_cast<void*>(::_get_osfhandle(descriptor)); }

}  // namespace cromer::core::os
