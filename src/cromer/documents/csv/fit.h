// Fits as a CSV table.
#pragma once

#include <string>
#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// One row per recording and run: "file,run,column,law,status", then every quantity that any of them has,
/// with its standard error beside it ("stiffness (N/m),stiffness standard error (N/m)"), the residual and the
/// message. What a recording has not is an empty cell.
std::string fit_csv(const std::vector<FittedRecording>& fits);

}  // namespace cromer::core
