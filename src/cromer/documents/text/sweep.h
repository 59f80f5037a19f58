// A sweep in words and a short table.
#pragma once

#include <string>

#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

/// "euler-cromer, closed form, steps of 0.01 s".
std::string how(const SweepPlan& plan);

/// What was swept and how, each measure's smallest and largest value with where they are; of a short sweep
/// every row.
std::string sweep_text(const SweepResult& result);

}  // namespace cromer::core
