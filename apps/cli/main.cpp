// cromer: arguments in, a task called, a result printed. The table of commands is here; each has a file of
// its own.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>

#include "commands.h"
#include "completions.h"
#include "cromer/base/nearest.h"
#include "cromer/os/process.h"
#include "cromer/version.h"
#include "manual.h"
#include "message.h"
#include "output.h"

namespace cromer::core::cli {
namespace {

constexpr Command commands[] = {
    {"simulate", "run the oscillator by one or more methods", run_simulate},
    {"methods", "list the methods of integration", run_methods},
    {"modes", "natural frequencies, damping and shapes of a network or a recording", run_modes},
    {"inspect", "say what is in a recording; convert it", run_inspect},
    {"fit", "find the law of motion from a recording", run_fit},
    {"compare", "lay simulations beside a recording", run_compare},
    {"sweep", "run the oscillator over grids of options: resonance curves, maps", run_sweep},
    {"spectrum", "response and shock spectra of a recorded acceleration", run_spectrum},
    {"record", "record from a sensor or a phone as it measures", run_record},
    {"serve", "the lab in the browser, with live recording", run_serve},
    {"report", "a report with figures of your recordings, or of a study", run_report},
};

std::string overview() {
  std::string text =
      "Usage: cromer COMMAND [OPTIONS]\n\nThe oscillator on a spring: from a recording to its law of "
      "motion.\n\nCommands:\n";
  for (const auto& command : commands) text += fmt::format("  {:<10}{}\n", command.name, command.description);
  text +=
      "\ncromer COMMAND --help explains a command, -h in short; cromer --version says which version this "
      "is;\n"
      "cromer help --man writes the manual page (--markdown: as Markdown); cromer completions bash (zsh, "
      "fish)\n"
      "completes commands and options in the shell.\n"
      "\nExample:\n  cromer simulate --stiffness 9 --damping 0.2 --drive-amplitude 1 --drive-frequency 3 "
      "--until 50 --plot run.svg\n";
  return text;
}

int unknown_command(std::string_view typed) {
  std::error_code error;
  if (std::filesystem::is_regular_file(typed, error))
    return refuse(
        fmt::format("\"{0}\" is a file: cromer inspect \"{0}\" tells what it holds, cromer report "
                    "\"{0}\" makes a report of it",
                    typed));
  std::vector<std::string_view> names;
  for (const auto& command : commands) names.push_back(command.name);
  const std::string near = nearest(typed, names);
  const std::string_view kind = typed.substr(0, 1) == "-" ? "option" : "command";
  return refuse(fmt::format("unknown {} \"{}\"{} See cromer --help", kind, typed,
                            near.empty() ? "." : fmt::format("; did you mean {}?", near)));
}

int run(const Arguments& arguments) {
  if (arguments.empty()) {
    complain("a command is needed");
    std::fputs(overview().c_str(), stderr);
    return wrong_input;
  }
  const std::string& first = arguments.front();
  if (first == "--version") return print_all("cromer " CROMER_VERSION "\n");
  if (first == "help" && arguments.size() > 1) {
    const std::string& asked = arguments[1];
    return asked == "--man" || asked == "--markdown" ? print_manual(asked, commands) : run({asked, "--help"});
  }
  if (first == "--help" || first == "-h" || first == "help") return print_all(overview());
  if (first == "completions") return run_completions({arguments.begin() + 1, arguments.end()}, commands);
  for (const auto& command : commands)
    if (command.name == first) return command.run(Arguments(arguments.begin() + 1, arguments.end()));
  return unknown_command(first);
}

}  // namespace
}  // namespace cromer::core::cli

int main(int count, char** words) {
  cromer::core::os::prepare_streams();
  try {
    return cromer::core::cli::run({words + 1, words + count});
  } catch (const std::bad_alloc&) {
    return cromer::core::cli::refuse("not enough memory for this");
  } catch (const std::exception& problem) {
    return cromer::core::cli::refuse(problem.what());
  }
}
