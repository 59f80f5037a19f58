// An option's name, "drive-frequency", as everything but the command line spells it.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace cromer::core {

/// "drive-frequency" as "drive_frequency".
inline std::string with_underscores(std::string_view option) {
  std::string name(option);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace cromer::core
