// Which fonts there are.
#pragma once

#include <string>

namespace cromer::core {

/// Whether fontconfig has a font of this family; without fontconfig none is known.
bool is_installed(const std::string& font_family);

}  // namespace cromer::core
