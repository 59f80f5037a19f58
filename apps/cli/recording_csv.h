// The columns of a recording as CSV: inspect -o.
#pragma once

#include <string>

#include "cromer/base/result.h"
#include "cromer/record/dialects/recording.h"

namespace cromer::cli {

/// Time first and strictly increasing, the other columns in the file's own units, whatever the dialect was.
Result<std::string> recording_csv(const Recording& recording, const ReadOptions& options);

}  // namespace cromer::cli
