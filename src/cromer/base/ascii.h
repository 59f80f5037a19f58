// Letters, digits and blanks of ASCII, whatever the locale is (all other bytes stay as they are), and the two
// spellings of an option's name.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace cromer::core {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

inline std::string lower(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = lower(c);
  return small;
}

/// Without blanks, tabs, line ends and no-break spaces at both ends.
constexpr std::string_view trimmed(std::string_view text) {
  constexpr std::string_view no_break_space = "\u00a0";
  constexpr auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  for (;;) {
    if (!text.empty() && is_blank(text.front()))
      text.remove_prefix(1);
    else if (!text.empty() && is_blank(text.back()))
      text.remove_suffix(1);
    else if (text.starts_with(no_break_space))
      text.remove_prefix(no_break_space.size());
    else if (text.ends_with(no_break_space))
      text.remove_suffix(no_break_space.size());
    else
      return text;
  }
}

/// The pieces of a text between separators, each trimmed; an empty text is one empty piece.
inline std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  for (;;) {
    const auto end = text.find(separator);
    pieces.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return pieces;
    text.remove_prefix(end + 1);
  }
}

/// An option's name, "drive-frequency", as everything but the command line spells it: "drive_frequency".
inline std::string with_underscores(std::string_view option) {
  std::string name(option);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// The option's name of it: with_underscores() back.
inline std::string with_hyphens(std::string_view name) {
  std::string option(name);
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}

}  // namespace cromer::core
