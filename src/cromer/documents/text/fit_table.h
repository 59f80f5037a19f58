// Many fits as one table for a terminal.
#pragma once

#include <string>
#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// One line per recording and run with what the laws have in common; one that failed says why.
std::string fit_table(const std::vector<FittedRecording>& fits);

}  // namespace cromer::core
