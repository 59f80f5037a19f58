// What two descriptions of work (JSON) do not agree in.
#pragma once

#include <string>

namespace cromer::core {

/// "stiffness is 9 there and 10 here; step is missing there": the first few, or "" where they are the same.
std::string differences(const std::string& there, const std::string& here);

}  // namespace cromer::core
