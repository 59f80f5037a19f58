// What two descriptions of work (JSON) do not agree in.
#pragma once

#include <string>
#include <vector>

#include "cromer/notice.h"

namespace cromer::core {

/// The first few, as "stiffness is 9 there and 10 here"; none where they are the same.
std::vector<Notice> differences(const std::string& there, const std::string& here);

}  // namespace cromer::core
