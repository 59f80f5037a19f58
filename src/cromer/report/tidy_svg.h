// gnuplot's SVG rewritten: small, without ids or fonts of its own, ready to stand in a page.
#pragma once

#include <string>
#include <string_view>

namespace cromer {

/// Keeps what is drawn (paths, areas, dots, words), as flat elements with colours as "#RRGGBB"; drops
/// wrappers, definitions, titles and ids, so that several pictures can share one page. Dots become one path
/// with round ends. The picture says `alternative_text` to those who cannot see it.
std::string tidy_svg(std::string_view from_gnuplot, std::string_view alternative_text);

}  // namespace cromer
