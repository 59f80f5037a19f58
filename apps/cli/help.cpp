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
  const std::string value = value_of(option);
  return "  " + names_of(option) + (value.empty() ? "" : " " + value);
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

/// As much of the option's first clause as a line of the terminal holds.
std::string_view in_short(std::string_view help) {
  help = help.substr(0, std::min(help.find_first_of(":("), help.find("; ")));
  while (help.ends_with(' ')) help.remove_suffix(1);
  return help;
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

std::string names_of(const Option& option) {
  return option.name == "output" ? "-o, --output" : fmt::format("--{}", option.name);
}

std::string value_of(const Option& option) {
  if (option.is_flag()) return "";
  if (option.name == "output" || option.name == "plot") return "FILE";
  if (option.is_text()) return kind_of_text(option.name);
  if (option.unit.empty() || option.unit == "1") return "NUMBER";
  return fmt::format("<{}>", option.unit);
}

std::string usage(const Syntax& syntax) {
  return fmt::format("cromer {}{}{} [OPTIONS]", syntax.command, syntax.files.empty() ? "" : " ",
                     syntax.files);
}

std::string help(const Syntax& syntax) {
  std::string out = fmt::format("Usage: {}\n\n{}\n", usage(syntax), syntax.description);
  for_each_option(
      syntax, [&](std::string_view group) { out += fmt::format("\n{}:\n", group); },
      [&](const Option& option) { append_option(out, option); });
  out += "  --help" + std::string(help_column - 8, ' ') + "this text\n";
  out +=
      "\nValues are SI numbers or texts with a unit, such as \"217.6 g\", \"12 cm\", \"3 Hz\". A frequency "
      "in Hz or rpm counts\n"
      "cycles and is multiplied by 2 pi. In brackets: the default.\n";
  out += fmt::format("\nExample:\n{}\n", syntax.example);
  return out;
}

std::string short_help(const Syntax& syntax) {
  std::string out = fmt::format("Usage: {}\n", usage(syntax));
  for_each_option(
      syntax, [&](std::string_view group) { out += fmt::format("\n{}:\n", group); },
      [&](const Option& option) {
        out += fmt::format("{:<{}}{}\n", left_side(option) + "  ", help_column, in_short(option.help));
      });
  return out + fmt::format("\ncromer {} --help says more, with an example.\n", syntax.command);
}

std::string option_list(const Syntax& syntax) {
  std::string out;
  for (const Option& option : syntax.options)
    out += fmt::format("--{}\t{}\n", option.name, in_short(option.help));
  return out + "--help\tall of it\n";
}

}  // namespace cromer::core::cli
