// The markup of names, titles and notes in figures: {/:Italic x} and {/:Bold x}, _0 or _{0} below the line,
// ^2 or ^{2} above it, and a backslash before a character that is meant as it stands; and how wide such a
// text is.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cromer::core {

/// A stretch of text in one style.
struct TextRun {
  std::string text;
  bool italic = false, bold = false;
  double size =
      1;  ///< as a share of the text's font size; 0.8 in a sub- or superscript, 0.64 in one of those
  double rise = 0;  ///< of its baseline over the text's, in font sizes

  friend bool operator==(const TextRun&, const TextRun&) = default;
};

/// The runs of one line. Every text can be read: braces that do not match are left out.
std::vector<TextRun> runs_of(std::string_view enhanced);

/// Plain text with its special characters escaped, for a name, title or note of a figure.
std::string figure_text(std::string_view plain);

/// The reverse, for alternative texts: without markup and escapes, line ends as blanks.
std::string without_markup(std::string_view enhanced);

/// The font of a figure. The font with which an SVG will be shown is not known here: it is measured as the
/// widest, DejaVu Sans.
enum class Typeface { lato, dejavu_sans };

/// Width in the unit of `size` of one line of enhanced text ("{/:Italic x}_{0}"), within 3 % for Latin text
/// and seldom too small.
double text_width(std::string_view text, double size, bool bold, Typeface typeface);

/// The lines of a text: broken at "\n", and at spaces outside of braces where a line would be wider than
/// `room`.
std::vector<std::string> wrapped(std::string_view text, double size, bool bold, Typeface typeface,
                                 double room);

}  // namespace cromer::core
