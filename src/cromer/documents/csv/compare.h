// Measured and simulated motions as CSV.
#pragma once

#include <string>
#include <vector>

#include "cromer/tasks/compare/compare.h"

namespace cromer::core {

/// "run,curve,t (s),measured displacement (m),simulated displacement (m)": from the fitted equilibrium, in
/// the SI unit of the column.
std::string compare_csv(const std::vector<CompareResult>& comparisons);

}  // namespace cromer::core
