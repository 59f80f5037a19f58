// What a cell is that is not a number, and the cure.
#pragma once

#include <string>
#include <string_view>

namespace cromer::core::dialects {

/// "it is a clock time: write the seconds since the start", "it has thousands separators: write 1000.0",
/// ...;
/// "" where nothing is recognised. Also dates, Fortran's D exponents, numbers beyond the doubles, and the
/// other decimal mark.
std::string bad_cell(std::string_view cell, char decimal);

}  // namespace cromer::core::dialects
