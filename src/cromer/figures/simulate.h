// The positions of simulated runs in one plot.
#pragma once

#include "cromer/report/figure.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// Methods by their own colours, the exact solution first; one method at several drive frequencies as an
/// ordered family. A run that grows without end is cut at the frame and said to grow.
Figure simulate_figure(const SimulateResult& result);

}  // namespace cromer::core
