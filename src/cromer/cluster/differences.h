// How two descriptions of work (JSON) differ.
#pragma once

#include <string>
#include <vector>

#include "cromer/notice.h"

namespace cromer::core {

/// The first few differences, as "stiffness is 9 there and 10 here"; none if the descriptions are the same.
std::vector<Notice> differences(const std::string& there, const std::string& here);

}  // namespace cromer::core
