// The fits of the recordings that a command line names.
#pragma once

#include <vector>

#include "cromer/tasks/fit/fit.h"
#include "many_files.h"

namespace cromer::core::cli {

/// The fits of all files in their order, each file's as if it were alone. One file that cannot be read is an
/// Error; of many it is a row that says why. After an interruption the files that were not begun are missing.
Result<std::vector<FittedRecording>> fit_all(const RecordingFiles& found, const FitOptions& options,
                                             const Watch& watch);

}  // namespace cromer::core::cli
