// A layout as an SVG: small, flat, without ids, style sheets or fonts of its own, ready to stand in a page
// beside others.
#pragma once

#include <string>
#include <string_view>

#include "cromer/report/layout.h"

namespace cromer::core {

/// Colours are written as "#RRGGBB", places to a hundredth of a px. The picture says `alternative_text` to
/// those who cannot see it; `font_family` is a list as in CSS, its quotes single.
std::string to_svg(const Layout& layout, std::string_view alternative_text, std::string_view font_family);

}  // namespace cromer::core
