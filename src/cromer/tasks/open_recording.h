// The file that a verb works on.
#pragma once

#include <string>
#include <vector>

#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core {

/// Reads the file at `path` ("-" is standard input). Messages call it `name`, or by its path where none is
/// given. An Error says why the file cannot be read, or names line, column and cure.
Result<Recording> open_recording(const std::string& path, const ReadOptions& options,
                                 const std::string& name = "");

/// All of them, or the first Error.
Result<std::vector<Recording>> open_recordings(const std::vector<std::string>& paths,
                                               const ReadOptions& options);

}  // namespace cromer::core
