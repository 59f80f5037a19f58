// How wide a text will be, without asking a font: figures measure their words before they give them room.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cromer::core {

/// The font a figure will be drawn with. An SVG is read with a font nobody knows here: it is measured as the
/// widest, DejaVu Sans.
enum class Typeface { lato, dejavu_sans };

/// Width in the unit of `size` of one line of enhanced text ("{/:Italic x}_{0}"), within 3 % for Latin text,
/// seldom too small.
double text_width(std::string_view text, double size, bool bold, Typeface typeface);

/// The lines of a text: broken at "\n", and at spaces outside of braces where a line would be wider than
/// `room`.
std::vector<std::string> wrapped(std::string_view text, double size, bool bold, Typeface typeface,
                                 double room);

}  // namespace cromer::core
