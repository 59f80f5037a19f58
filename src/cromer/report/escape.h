// Text made safe for HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace cromer::core {

/// & < > " ' as character references.
std::string escaped(std::string_view text);

/// A whole document as XML reads it: UTF-8; control characters and marks that change the direction of writing
/// are spelled out, as on a terminal.
std::string well_formed(std::string document);

}  // namespace cromer::core
