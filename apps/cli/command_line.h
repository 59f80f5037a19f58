// The command line as it was typed, to head what it wrote.
#pragma once

#include <string>
#include <string_view>

#include "commands.h"

namespace cromer::cli {

/// On one line, each word quoted where a shell would need it.
std::string command_line(std::string_view command, const Arguments& arguments);

}  // namespace cromer::cli
