// Which program wrote a file, told from its header.
#pragma once

#include <string_view>

#include "cromer/read/header.h"

namespace cromer::core::dialects {

/// "PASCO Capstone", "DataStudio", "Tracker", "Logger Pro", "Graphical Analysis", "phyphox", or "plain".
std::string_view dialect_name(const Header& header);

}  // namespace cromer::core::dialects
