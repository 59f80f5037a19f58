// Files that only the program that wrote them reads.
#pragma once

#include <string_view>

#include "cromer/notice.h"

namespace cromer::core::dialects {

/// The menu by which that program exports its data, found by the ending of the file's name; empty of other
/// endings.
Notice export_menu(std::string_view file);

}  // namespace cromer::core::dialects
