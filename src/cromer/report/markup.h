// The small markup of a report's texts, taken apart.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cromer::core {

/// Words and code have a text, all others parts. Of `both` these are what stands above and what stands below.
struct Piece {
  enum class Kind { words, code, italic, bold, above, below, both };
  Kind kind = Kind::words;
  std::string text;
  std::vector<Piece> parts;
};

/// One paragraph: *italic*, **bold**, `code` (nothing inside it is markup), x_{0}, x^{2}, nested as they
/// come; x_{d}^{2} stands one above the other. A star with a blank at its inner side, or without its partner,
/// is a star. A number keeps its unit on its line, by a no-break space; it has a true minus sign and a power of
/// ten for an exponent. An option, --mass, is code.
std::vector<Piece> pieces_of(std::string_view text);

/// Paragraphs are separated by blank lines; line ends within one are blanks.
std::vector<std::string> paragraphs_of(std::string_view text);

/// The words without markup.
std::string words_of(const std::vector<Piece>& pieces);

}  // namespace cromer::core
