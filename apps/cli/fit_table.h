// Many fits as one table for a terminal.
#pragma once

#include <string>
#include <vector>

#include "cromer/study/task/fit.h"

namespace cromer::core::cli {

/// One line per recording and run with what the laws have in common; one that failed says why.
std::string fit_table(const std::vector<FittedRecording>& fits);

}  // namespace cromer::core::cli
