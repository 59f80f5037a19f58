// Spring constants from several masses as CSV tables.
#pragma once

#include <string>

#include "cromer/tasks/fit/spring_constant.h"

namespace cromer::core {

/// A row for each hold; the spring constant stands in each of them.
std::string static_csv(const StaticStiffness& found);

/// A row for each recording: mass, period squared, what the line leaves; and what follows from the line.
std::string mass_line_csv(const MassLine& line);

}  // namespace cromer::core
