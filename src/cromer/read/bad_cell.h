// What a cell is that is not a number, and the cure.
#pragma once

#include <string_view>

#include "cromer/notice.h"

namespace cromer::core::dialects {

/// A clock time, a number with thousands separators, a date, Fortran's D exponents, a number beyond the
/// doubles, the other decimal mark; empty where nothing is recognised.
Notice bad_cell(std::string_view cell, char decimal);

}  // namespace cromer::core::dialects
