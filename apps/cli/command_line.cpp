#include "command_line.h"

#include <algorithm>

namespace cromer::core::cli {
namespace {

/// In single quotes; a quote inside ends them, stands escaped, and opens them again.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

}  // namespace

std::string command_line(std::string_view command, const Arguments& arguments) {
  std::string line = "cromer " + std::string(command);
  for (const auto& word : arguments) {
    const bool plain =
        !word.empty() && word.find_first_of(" \t\n\"'$*?;&|<>()`\\#~!{}[]") == std::string::npos;
    line += plain ? " " + word : " " + quoted(word);
  }
  std::replace(line.begin(), line.end(), '\n', ' ');
  return line;
}

}  // namespace cromer::core::cli
