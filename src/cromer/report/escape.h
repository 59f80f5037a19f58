// Text made safe for HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace cromer {

/// & < > " ' as character references; control characters that XML does not allow are left out.
std::string escaped(std::string_view text);

}  // namespace cromer
