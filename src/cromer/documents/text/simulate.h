// What `cromer simulate` prints: the runs, then what a reader should know of them.
#pragma once

#include <string>

#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// The runs' ends, their events, the steps that --accuracy chose, the steady motion and what gets through,
/// and what each method made of the law.
std::string simulate_text(const SimulateResult& result);

}  // namespace cromer::core
