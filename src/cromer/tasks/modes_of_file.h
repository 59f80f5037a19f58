// The modes in a file, be it a network's or a recording.
#pragma once

#include <string>

#include "cromer/result.h"
#include "cromer/tasks/modes/modes.h"

namespace cromer::core {

/// A file of a network ends in .toml (is_network_file); a recording may be set beside one. An Error names
/// file, line, option and cure.
Result<ModesResult> modes_of_file(const std::string& path, const ModesOptions& options);

}  // namespace cromer::core
