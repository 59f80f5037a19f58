// A recording beside its simulations as a text for people.
#pragma once

#include <string>
#include <vector>

#include "cromer/tasks/compare/compare.h"

namespace cromer::core {

/// A table of the curves of each run, and whether one decay rate is enough; what else was asked of the fit
/// comes first.
std::string compare_text(const std::vector<CompareResult>& comparisons);

}  // namespace cromer::core
