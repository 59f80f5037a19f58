// Names and estimates of a fit as a terminal shows them.
#pragma once

#include <string>
#include <string_view>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// "decay rate" for decay_rate.
std::string readable_name(std::string_view name);

/// Value and standard error with the unit; that of a plain number is "1" or "".
std::string in_words(const Estimate& estimate, std::string_view unit);

/// The SI unit of the column that was fitted, as its equilibrium has it; "" where nothing was fitted.
std::string fitted_unit(const FittedRecording& fitted);

}  // namespace cromer::core
