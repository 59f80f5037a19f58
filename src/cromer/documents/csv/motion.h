// The fitted motion, sample by sample, as a CSV table.
#pragma once

#include <string>
#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// "file,run,t (s),measured (m),x (m),v (m/s),energy (J),residual (m),v from the samples (m/s),set aside" of
/// every fit that has values; the units are the column's.
std::string motion_csv(const std::vector<FittedRecording>& fits);

}  // namespace cromer::core
