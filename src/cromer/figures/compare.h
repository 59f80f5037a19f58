// A recording and simulations of it, laid over each other.
#pragma once

#include <vector>

#include "cromer/report/figure.h"
#include "cromer/tasks/compare/compare.h"

namespace cromer::core {

/// One panel for each simulated curve, the measured motion under it.
Figure compare_figure(const std::vector<CompareResult>& comparisons);

}  // namespace cromer::core
