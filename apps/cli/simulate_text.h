// What `cromer simulate` prints: the runs, then what a reader should know of them.
#pragma once

#include <string>

#include "cromer/study/task/simulate.h"

namespace cromer::core::cli {

/// The runs' ends, their events, the steps that --accuracy chose, the steady motion and what gets through,
/// and what each method made of the law.
std::string simulate_text(const SimulateResult& result);

}  // namespace cromer::core::cli
