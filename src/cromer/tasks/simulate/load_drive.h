// The recorded drive that the options of `simulate` name, read from its file.
#pragma once

#include <string>

#include "cromer/result.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// Fills options.drive_record where a --drive-file or a --base-motion is named, its path relative to
/// `folder`; otherwise does nothing. An Error says what is wrong with the file.
Result<void> load_drive(SimulateOptions& options, const std::string& folder);

}  // namespace cromer::core
