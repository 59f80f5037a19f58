#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>

#include "completions.h"
#include "cromer/base/ascii.h"
#include "cromer/base/nearest.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/option_owner.h"
#include "manual.h"
#include "message.h"
#include "output.h"
#include "syntax.h"

namespace cromer::core::cli {
namespace {

/// Looks like an option, not like a value: a negative number has one dash and no letter after it.
bool is_option(std::string_view word) { return word == "-o" || word.substr(0, 2) == "--"; }

/// What was typed for one option of the table.
struct Typed {
  const Option* option;
  std::vector<std::string> texts;
  bool flag = false;
};

int unknown_option(const Syntax& syntax, const std::string& typed) {
  std::vector<std::string_view> names{"help"};
  for (const auto& option : syntax.options) names.push_back(option.name);
  const std::string_view bare =
      std::string_view(typed).substr(std::min(typed.size(), typed.find_first_not_of('-')));
  const std::string_view name = bare.substr(0, bare.find('='));
  const bool is_right_but_for_dashes = std::find(names.begin(), names.end(), name) != names.end();
  if (syntax.refusal && !is_right_but_for_dashes)
    if (const Notice why = syntax.refusal(name, ""); !why.empty()) return refuse(Error{why});
  const std::string_view owner = is_option_of_page(name) ? "report" : option_owner(name);
  if (!owner.empty() && !is_right_but_for_dashes)
    return refuse(fmt::format("--{} is an option of cromer {}, not of cromer {}; see cromer {} --help", name,
                              owner, syntax.command, syntax.command));
  const std::string near = nearest(name, names);
  return refuse(fmt::format("unknown option {}{} See cromer {} --help", typed,
                            near.empty() ? "." : fmt::format("; did you mean --{}?", near), syntax.command));
}

/// Grams or kilograms? The refusal of a value without a unit that is large for what the option takes it for.
std::string unit_in_doubt(const Option& option, std::string_view text) {
  bool much = false;
  for (const std::string_view part : split(text, ',')) {
    const auto bare = parse_quantity(part, "1");
    if (!bare) return "";
    much = much || bare->value >= option.doubtful_from;
  }
  if (!much) return "";
  return fmt::format("--{0} {1}: would be {2}, which is much; write --{0} \"{1} {3}\" or --{0} \"{1} {2}\"",
                     option.name, text, option.unit, option.unit == "kg" ? "g" : "cm");
}

bool is_there(const std::string& path) {
  std::error_code none;
  return std::filesystem::exists(path, none);
}

bool is_of_unit(const Option& option) { return !option.unit.empty() && !option.is_text(); }

/// A text of one's own, or a name that stands in a file; not one of a list.
bool may_be_words(const Option& option) {
  static constexpr std::string_view own[] = {"author", "column", "course", "text", "title"};
  return std::find(std::begin(own), std::end(own), option.name) != std::end(own);
}

/// No option, no file, and not named like one: the dot of "B." is an initial's.
bool is_word(const std::string& argument) {
  const std::size_t mark = argument.find_first_of("./\\");
  const bool is_initial = mark + 1 == argument.size() && argument.back() == '.';
  return !is_option(argument) && !is_there(argument) && (mark == argument.npos || is_initial);
}

/// The refusal of a value in several words: `--mass 217.6 g`, `--author A. Student` without its quotes.
std::string value_without_quotes(const Syntax& syntax, const Arguments& arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::size_t equals = arguments[i].find('=');
    const std::string name = arguments[i].substr(0, equals);
    const auto option = std::find_if(syntax.options.begin(), syntax.options.end(), [&](const Option& each) {
      return name == "--" + std::string(each.name);
    });
    if (option == syntax.options.end() || !(may_be_words(*option) || is_of_unit(*option))) continue;
    const bool is_quantity = is_of_unit(*option);
    std::size_t next = i + 1;
    std::string value = equals < name.npos        ? arguments[i].substr(equals + 1)
                        : next < arguments.size() ? arguments[next++]
                                                  : "";
    std::string whole;  // the most words that make a value
    const auto goes_on = [&](const std::string& word) {
      return is_quantity ? !is_option(word) && !is_there(word) : is_word(word);
    };
    for (; next < arguments.size() && goes_on(arguments[next]); ++next) {
      value += " " + arguments[next];
      if (!is_quantity || parse_quantity(value, option->unit)) whole = value;
    }
    if (!whole.empty())
      return fmt::format("{0} {1}: put a value of several words in quotes: {0} \"{1}\"", name, whole);
  }
  return "";
}

/// The refusal of a value that stands where files do: `"217.6 g"` without --mass.
std::string value_without_option(const Syntax& syntax, const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    if (is_there(file) || parse_quantity(file, "1")) continue;
    for (const Option& option : syntax.options)
      if (is_of_unit(option) && parse_quantity(file, option.unit))
        return fmt::format("{}: there is no such file; did you mean --{} \"{}\"?", file, option.name, file);
  }
  return "";
}

Result<void> assign_all(const Syntax& syntax, const std::vector<Typed>& typed) {
  for (const auto& [option, texts, flag] : typed) {
    if (flag)
      if (auto good = assign(*option, "true"); !good) return good;
    if (texts.size() > 1 && !option->is_list())
      return Error{"given_several_times", {{"option", option->name}, {"times", texts.size()}}};
    for (const auto& text : texts)
      if (auto good = assign(*option, text); !good) {
        const Notice why = syntax.refusal ? syntax.refusal(option->name, text) : Notice{};
        return why.empty() ? good : Error{why};
      }
  }
  return {};
}

}  // namespace

std::optional<int> parse(const Syntax& syntax, const Arguments& arguments, std::vector<std::string>& files,
                         std::vector<TypedOption>* given) {
  const auto asked_for = [&](std::string_view word) {
    return std::find(arguments.begin(), arguments.end(), word) != arguments.end();
  };
  if (asked_for("--help")) return print_all(help(syntax));
  if (asked_for("-h")) return print_all(short_help(syntax));
  if (arguments.size() == 1 && asked_for(list_options)) return print_all(option_list(syntax));
  if (arguments.size() == 1 && asked_for(as_man)) return print_all(man_section(syntax));
  if (arguments.size() == 1 && asked_for(as_markdown)) return print_all(markdown_section(syntax));

  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  std::vector<Typed> typed;
  typed.reserve(syntax.options.size());  // CLI11 keeps pointers into it
  for (const auto& option : syntax.options) {
    auto& entry = typed.emplace_back(Typed{&option, {}, false});
    const std::string names = (option.name == "output" ? "-o,--" : "--") + std::string(option.name);
    if (option.is_flag()) {
      app.add_flag(names, entry.flag);
      const std::string flag = fmt::format("--{}", option.name);
      if (std::any_of(arguments.begin(), arguments.end(),
                      [&](const std::string& each) { return each.rfind(flag + "=", 0) == 0; }))
        return refuse(flag + " takes no value");
    } else {
      app.add_option(names, entry.texts)
          ->expected(1)
          ->allow_extra_args(false)
          ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    }
  }
  try {
    app.parse(Arguments(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ArgumentMismatch& problem) {
    const std::string_view what = problem.what();
    return refuse(fmt::format("{} needs a value", what.substr(0, what.find(':'))));
  } catch (const CLI::ParseError& problem) {
    return refuse(problem.what());
  }

  for (const auto& [option, texts, flag] : typed)
    for (const auto& text : texts)
      if (is_option(text))
        return refuse(fmt::format("--{} needs a value, and {} is an option", option->name, text));
  for (const std::string& word : arguments)  // which -o would take for a file named "ut"
    if (const std::string name = word.substr(0, word.find('=')); name == "-out" || name == "-output")
      return unknown_option(syntax, name);
  for (const auto& left : app.remaining()) {
    if (left.size() > 1 && left.front() == '-') return unknown_option(syntax, left);
    files.push_back(left);
  }
  if (!files.empty())
    if (const std::string why = value_without_quotes(syntax, arguments); !why.empty()) return refuse(why);
  if (const std::string why = value_without_option(syntax, files); !why.empty()) return refuse(why);
  if (syntax.files.empty() && !files.empty())
    return refuse(fmt::format("{} takes no file, but \"{}\" is given", syntax.command, files.front()));
  if (!syntax.files.empty() && files.empty())
    return refuse(fmt::format("{} needs a file; see cromer {} --help", syntax.command, syntax.command));
  if (syntax.files == "FILE" && files.size() > 1)
    return refuse(fmt::format("{} takes one file, but {} are given", syntax.command, files.size()));
  if (auto good = assign_all(syntax, typed); !good) return refuse(good.error());
  for (const auto& [option, texts, flag] : typed)
    for (const auto& text : texts)
      if (const std::string why = unit_in_doubt(*option, text); !why.empty()) return refuse(why);
  if (given)
    for (const auto& [option, texts, flag] : typed) {
      if (flag) given->emplace_back(option->name, "true");
      for (const auto& text : texts) given->emplace_back(option->name, text);
    }
  return std::nullopt;
}

std::string command_line(std::string_view command, const Arguments& arguments) {
  std::string line = "cromer " + std::string(command);
  for (const auto& word : arguments) line += " " + as_one_word(word);
  std::replace(line.begin(), line.end(), '\n', ' ');
  return line;
}

}  // namespace cromer::core::cli
