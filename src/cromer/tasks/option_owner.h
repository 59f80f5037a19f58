// Which command has an option, for people who give it to another.
#pragma once

#include <string_view>

namespace cromer::core {

/// The first of fit, simulate, compare, spectrum, modes and methods that has an option of this name; "" if
/// none has.
std::string_view option_owner(std::string_view name);

}  // namespace cromer::core
