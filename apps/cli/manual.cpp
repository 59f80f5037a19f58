// The manual, from the same tables as --help: as a page for man, and as Markdown.
#include "manual.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "cromer/documents/text.h"
#include "cromer/version.h"
#include "output.h"

namespace cromer::core::cli {
namespace {

constexpr std::string_view about =
    "Cromer reads a logger's file as it comes, finds stiffness, damping and drag with their uncertainties, "
    "simulates that law with the classical methods, and lays both side by side.";
constexpr std::string_view values =
    "Values are SI numbers or texts with a unit and, where it makes sense, an uncertainty: \"217.6 g\", "
    "\"217.6 ± 0.3 g\", \"0.2176(3) kg\", \"12 cm\", \"3 Hz\". A frequency in Hz or rpm counts cycles and is "
    "multiplied by 2 pi. The default stands in brackets.";

struct ExitStatus {
  int status;
  std::string_view means;
};
constexpr ExitStatus statuses[] = {
    {done, "The answer is there."},
    {no_success,
     "The computation did not succeed: it diverged, did not converge, found no oscillation, or was "
     "interrupted. What there is of it is written."},
    {wrong_input, "Options, files or outputs were wrong."},
};

/// Text of a man page: nothing in it is a request or an escape.
std::string man(std::string_view text) {
  std::string out;
  char before = '\n';
  for (const char c : text) {
    if (before == '\n' && (c == '.' || c == '\'')) out += "\\&";
    switch (before = c) {
      case '\\':
        out += "\\e";
        break;
      case '-':
        out += "\\-";
        break;
      case '^':
        out += "\\(ha";
        break;
      case '~':
        out += "\\(ti";
        break;
      case '\'':
        out += "\\(aq";
        break;
      case '`':
        out += "\\(ga";
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// What Markdown would take for its own is escaped.
std::string markdown(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\|*_<>[]`").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

/// A heading of --help as a heading and what it goes on to say: "Law of motion: m x'' = ...".
std::pair<std::string_view, std::string_view> title_and_rest(std::string_view group) {
  const std::size_t end = group.find(": ");
  if (end == std::string_view::npos) return {group, {}};
  return {group.substr(0, end), group.substr(end + 2)};
}

std::string man_head(std::span<const Command> commands) {
  std::string out = ".TH CROMER 1 \"\" \"cromer " CROMER_VERSION "\" \"User Commands\"\n";
  out += ".SH NAME\ncromer \\- from a recording of something that swings to its law of motion\n";
  out += ".SH SYNOPSIS\n.B cromer\n.I COMMAND\n[\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n" + man(about) + '\n';
  out += ".SH COMMANDS\n";
  for (const Command& command : commands)
    out += fmt::format(".TP\n.B {}\n{}\n", man(command.name), man(command.description));
  return out;
}

std::string man_foot() {
  std::string out = ".SH VALUES\n" + man(values) + "\n.SH EXIT STATUS\n";
  for (const auto& [status, means] : statuses) out += fmt::format(".TP\n.B {}\n{}\n", status, man(means));
  return out;
}

std::string markdown_head(std::span<const Command> commands) {
  std::string out = fmt::format("# Commands\n\n{}\n\n| command | what it does |\n|---|---|\n", about);
  for (const Command& command : commands)
    out += fmt::format("| `cromer {}` | {} |\n", command.name, markdown(command.description));
  out += fmt::format("\n{}\n\n| exit status | what it means |\n|---|---|\n", values);
  for (const auto& [status, means] : statuses) out += fmt::format("| {} | {} |\n", status, means);
  return out;
}

}  // namespace

int print_manual(std::string_view form, std::span<const Command> commands) {
  const bool for_man = form == "--man";
  int status = print_all(for_man ? man_head(commands) : markdown_head(commands));
  for (const Command& command : commands)
    if (status == done) status = command.run({std::string(for_man ? as_man : as_markdown)});
  return status == done && for_man ? print_all(man_foot()) : status;
}

std::string man_section(const Syntax& syntax) {
  std::string out = fmt::format(".SH CROMER {}\n", syntax.command);
  for (char& c : out) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  out += fmt::format(".B {}\n.PP\n{}\n", man(usage(syntax)), man(syntax.description));
  for_each_option(
      syntax,
      [&](std::string_view group) {
        const auto [title, rest] = title_and_rest(group);
        out += fmt::format(".SS \"{}\"\n{}", man(title), rest.empty() ? "" : man(rest) + '\n');
      },
      [&](const Option& option) {
        const std::string value = value_of(option);
        out += fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", man(names_of(option)),
                           value.empty() ? "" : " \\fI" + man(value) + "\\fR", man(option_text(option)));
      });
  return out + fmt::format(".SS Example\n.EX\n{}\n.EE\n", man(syntax.example));
}

std::string markdown_section(const Syntax& syntax) {
  std::string out = fmt::format("\n# cromer {}\n\n```text\n{}\n```\n\n{}\n", syntax.command, usage(syntax),
                                markdown(syntax.description));
  for_each_option(
      syntax,
      [&](std::string_view group) {
        const auto [title, rest] = title_and_rest(group);
        out += fmt::format("\n## {}\n\n{}| option | what it is |\n|---|---|\n", markdown(title),
                           rest.empty() ? "" : markdown(rest) + "\n\n");
      },
      [&](const Option& option) {
        const std::string value = value_of(option);
        out += fmt::format("| `{}{}` | {} |\n", names_of(option), value.empty() ? "" : " " + value,
                           markdown(option_text(option)));
      });
  out += "\n## Example\n\n```sh\n";
  std::string_view example = syntax.example;
  while (!example.empty()) {
    const auto end = example.find('\n');
    const std::string_view line = example.substr(0, end);
    out += fmt::format("{}\n", line.substr(std::min(line.size(), line.find_first_not_of(' '))));
    example = end == std::string_view::npos ? std::string_view{} : example.substr(end + 1);
  }
  return out + "```\n";
}

}  // namespace cromer::core::cli
