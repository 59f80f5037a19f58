// One line of a device's text, taken apart.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cromer::core {

/// What a line turned out to be. A comment begins with # or %.
enum class LineKind { blank, comment, numbers, words, garbage };

struct Line {
  LineKind kind = LineKind::blank;
  std::vector<double> numbers{};     ///< of a line of numbers; NaN where one is missing
  std::vector<std::string> words{};  ///< of a line without any number: what may be a heading
};

/// Fields end at commas, semicolons, tabs or blanks. Beside semicolons or tabs a comma is a decimal mark; a
/// lone `12,5` is two fields. An empty field, nan and null are missing values; a line of missing values only
/// is one of numbers. Numbers and words mixed, or bytes that are no text, are garbage.
Line read_line(std::string_view text);

/// Text fit to be shown to a person: at most `longest` characters and then "...", what is not printable ASCII
/// as "?".
std::string shown(std::string_view text, std::size_t longest = 40);

}  // namespace cromer::core
