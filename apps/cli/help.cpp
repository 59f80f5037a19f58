#include <fmt/format.h>

#include "cromer/documents/text.h"
#include "syntax.h"

namespace cromer::core::cli {
namespace {

constexpr std::size_t help_column = 34;
constexpr std::size_t last_column = 110;

/// A name only where something is called by it: a column, a method, a law, a reading.
std::string kind_of_text(std::string_view option) {
  for (const std::string_view named : {"column", "method", "law", "between-samples", "drive"})
    if (option == named || option.ends_with("-column")) return "NAME";
  for (const std::string_view file : {"motion", "drive-file", "base-motion"})
    if (option == file) return "FILE";
  return "TEXT";
}

std::string left_side(const Option& option) {
  std::string text = option.name == "output" ? "  -o, --output" : fmt::format("  --{}", option.name);
  if (option.is_flag()) return text;
  if (option.name == "output" || option.name == "plot") return text + " FILE";
  if (option.is_text()) return text + " " + kind_of_text(option.name);
  if (option.unit.empty() || option.unit == "1") return text + " NUMBER";
  return text + fmt::format(" <{}>", option.unit);
}

/// Words of `text` from help_column on, in lines of at most last_column.
void append_wrapped(std::string& out, std::string_view text) {
  std::size_t column = help_column;
  while (!text.empty()) {
    const auto end = text.find(' ');
    const std::string_view word = text.substr(0, end);
    if (column > help_column && column + 1 + word.size() > last_column) {
      out += '\n' + std::string(help_column, ' ');
      column = help_column;
    } else if (column > help_column) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  }
}

void append_option(std::string& out, const Option& option) {
  const std::string text = option_text(option);
  const std::string left = left_side(option);
  out += left;
  out += left.size() + 2 > help_column ? '\n' + std::string(help_column, ' ')
                                       : std::string(help_column - left.size(), ' ');
  append_wrapped(out, text);
  out += '\n';
}

}  // namespace

std::string help(const Syntax& syntax) {
  std::string out = fmt::format("Usage: cromer {}{}{} [OPTIONS]\n\n{}\n", syntax.command,
                                syntax.files.empty() ? "" : " ", syntax.files, syntax.description);
  std::string_view group;
  for (const auto& option : syntax.options) {
    if (option.group != group) {
      group = option.group;
      out += fmt::format("\n{}:\n", group);
    }
    append_option(out, option);
  }
  out += "  --help" + std::string(help_column - 8, ' ') + "this text\n";
  out +=
      "\nValues are SI numbers or texts with a unit, such as \"217.6 g\", \"12 cm\", \"3 Hz\". A frequency "
      "in Hz or rpm counts\n"
      "cycles and is multiplied by 2 pi. In brackets: the default.\n";
  out += fmt::format("\nExample:\n{}\n", syntax.example);
  return out;
}

}  // namespace cromer::core::cli
