// Text made safe for HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace cromer {

/// & < > " ' as character references; control characters that XML does not allow are left out.
std::string escaped(std::string_view text);

/// A whole document as XML reads it: UTF-8, without the characters that XML does not allow.
std::string well_formed(std::string document);

}  // namespace cromer
