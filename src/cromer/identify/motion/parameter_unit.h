// Units of what a fit adjusts, in the words of the record's own.
#pragma once

#include <string>
#include <string_view>

#include "cromer/identify/motion/motion.h"

namespace cromer::core {

/// Unit of the displacement, "m", from the unit of a derivative of it, "m", "m/s" or "m/s²".
std::string displacement_unit(std::string_view unit, int derivative);

/// Unit of a parameter of the motion's law per unit mass, or of its drive or start. `observed` is the unit of
/// the record, `derivative` says which derivative of the displacement it is. `force_unit` is that of a
/// recorded force; "" if there is none or it is not known.
std::string unit_of_parameter(std::string_view name, const Motion& motion, std::string_view observed,
                              int derivative, std::string_view force_unit = {});

}  // namespace cromer::core
