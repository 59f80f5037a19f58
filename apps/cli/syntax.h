// What a command accepts, and the parsing of its arguments.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "commands.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core::cli {

struct Syntax {
  std::string_view command;
  std::string_view description;  ///< the first lines of --help
  std::string_view files;        ///< "FILE", "FILE..." or "" where none are taken
  std::vector<Option> options;   ///< in the order of --help
  std::string_view example;      ///< one or more command lines
  /// What this command has to say of an option, or a value, that it does not take; empty: what all say.
  Notice (*refusal)(std::string_view option, std::string_view text) = nullptr;
};

/// Assigns every option and collects the files. Returns the exit status where there is nothing left to do:
/// --help was printed, or an error said. `given` gets the options as they were typed.
std::optional<int> parse(const Syntax& syntax, const Arguments& arguments, std::vector<std::string>& files,
                         std::vector<TypedOption>* given = nullptr);

/// The text of --help.
std::string help(const Syntax& syntax);

/// The text of -h: a line for each option.
std::string short_help(const Syntax& syntax);

/// "--mass", a tab, what it is: a line for each option.
std::string option_list(const Syntax& syntax);

/// "cromer fit FILE... [OPTIONS]".
std::string usage(const Syntax& syntax);

/// "--mass"; "-o, --output".
std::string names_of(const Option& option);

/// What follows its name: "<kg>", "NAME", "NUMBER"; "" after a flag.
std::string value_of(const Option& option);

/// Calls for each group's heading, and for each option.
template <class Heading, class Line>
void for_each_option(const Syntax& syntax, const Heading& heading, const Line& line) {
  std::string_view group;
  for (const Option& option : syntax.options) {
    if (option.group != group) heading(group = option.group);
    line(option);
  }
}

/// "cromer COMMAND ...", each word quoted where a shell would need it: what made a file stands in the file.
std::string command_line(std::string_view command, const Arguments& arguments);

}  // namespace cromer::core::cli
