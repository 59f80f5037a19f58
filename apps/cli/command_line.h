// The command line as a text that a shell reads back: provenance of what was written.
#pragma once

#include <string>
#include <string_view>

#include "commands.h"

namespace cromer::core::cli {

/// "cromer COMMAND ...", each word quoted where a shell would need it.
std::string command_line(std::string_view command, const Arguments& arguments);

}  // namespace cromer::core::cli
