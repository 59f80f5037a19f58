// A list of masses as typed.
#pragma once

#include <string_view>
#include <vector>

#include "cromer/base/quantity.h"

namespace cromer::core {

/// Reads "48.4 g, 67.95 ± 0.01 g, 0.088": parts between commas, each a quantity in kg; a part without unit
/// takes the unit of the next that has one ("48.4, 67.95, 87.96 g"), and is in kg where none has. All must be
/// zero or more. Errors begin with the option.
Result<std::vector<Quantity>> parse_masses(std::string_view text);

}  // namespace cromer::core
