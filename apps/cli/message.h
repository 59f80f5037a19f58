// Messages on standard error, all beginning with "cromer: ".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cromer::core::cli {

/// From here on this process says nothing, on neither stream: another one says the same.
void fall_silent();

/// Says what went wrong.
void complain(std::string_view message);

/// complain, and the exit status for wrong input.
int refuse(std::string_view message);

/// Each as "cromer: warning: ...", unless quiet.
void warn(const std::vector<std::string>& warnings, bool quiet);

}  // namespace cromer::core::cli
