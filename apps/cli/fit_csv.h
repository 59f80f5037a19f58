// Fits as a CSV table.
#pragma once

#include <string>
#include <vector>

#include "cromer/study/task/fit.h"

namespace cromer::cli {

/// One row per quantity: "file,column,run,quantity,value,standard_error,low,high,unit".
std::string fit_csv(const std::vector<FittedRecording>& fits);

}  // namespace cromer::cli
