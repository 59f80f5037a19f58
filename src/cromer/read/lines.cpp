#include "cromer/read/lines.h"

namespace cromer::core::dialects {

std::vector<std::string_view> split_lines(std::string_view text) {
  const char end = text.find('\n') == std::string_view::npos ? '\r' : '\n';
  std::vector<std::string_view> lines;
  lines.reserve(text.size() / 24 + 1);
  while (!text.empty()) {
    const std::size_t length = text.find(end);
    std::string_view line = text.substr(0, length);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    lines.push_back(line);
    if (length == std::string_view::npos) return lines;
    text.remove_prefix(length + 1);
  }
  lines.emplace_back();
  return lines;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view no_break_space = "\u00a0";
  for (;;) {
    if (text.starts_with(' ') || text.starts_with('\t') || text.starts_with('\r')) {
      text.remove_prefix(1);
    } else if (text.ends_with(' ') || text.ends_with('\t') || text.ends_with('\r')) {
      text.remove_suffix(1);
    } else if (text.starts_with(no_break_space)) {
      text.remove_prefix(no_break_space.size());
    } else if (text.ends_with(no_break_space)) {
      text.remove_suffix(no_break_space.size());
    } else {
      return text;
    }
  }
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

bool is_comment(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && (line[first] == '#' || line[first] == '%');
}

}  // namespace cromer::core::dialects
