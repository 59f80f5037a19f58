// Spring constants from several masses as figures.
#pragma once

#include "cromer/report/figure.h"
#include "cromer/tasks/fit/spring_constant.h"

namespace cromer::core {

/// Position at rest against mass, and what the line leaves.
Figure static_figure(const StaticStiffness& found);

/// Period squared against mass, and what the line leaves.
Figure mass_line_figure(const MassLine& line);

}  // namespace cromer::core
