// The names of a recording's columns.
#pragma once

#include <string>
#include <string_view>

namespace cromer::core {

/// One that can stand in a CSV file without quotes, without blanks at its ends.
std::string plain_heading(std::string text);

/// Whether it is called so, with its unit or without: "Position" or "Position (mm)".
bool is_named(std::string_view heading, std::string_view name);

}  // namespace cromer::core
