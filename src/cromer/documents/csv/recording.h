// The columns of a recording as CSV: inspect -o.
#pragma once

#include <string>

#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core {

/// Time first and strictly increasing, the other columns in the file's own units, whatever the dialect was.
Result<std::string> recording_csv(const Recording& recording, const ReadOptions& options);

}  // namespace cromer::core
