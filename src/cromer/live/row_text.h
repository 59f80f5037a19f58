// A row of a recording as a line of CSV.
#pragma once

#include <span>
#include <string>

namespace cromer::core {

/// Adds "t,value,...\n", each with the fewest digits that read back as the same number; nothing where one is
/// not finite.
void append_row(std::string& text, double t, std::span<const double> values);

}  // namespace cromer::core
