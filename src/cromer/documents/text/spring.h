// Spring constants from several masses as a text for people.
#pragma once

#include <string>

#include "cromer/tasks/fit/spring_constant.h"

namespace cromer::core {

/// The holds, and the spring constant that they give.
std::string static_text(const StaticStiffness& found);

/// One line, to stand under the table of the fits.
std::string mass_line_text(const MassLine& line);

}  // namespace cromer::core
