// The slanting lines of a tripartite plot.
#pragma once

#include "cromer/report/figure.h"

namespace cromer::core {

/// Frames the panel's curves (pseudo-velocity [m/s] against period [s], both axes logarithmic) and puts under
/// them the lines on which the displacement, or the pseudo-acceleration (in g if asked), is the same.
void add_equal_lines(Panel& panel, bool in_g);

}  // namespace cromer::core
