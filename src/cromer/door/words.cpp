#include "cromer/door/words.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/methods/methods.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {
namespace {

bool is_of_option(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; }

/// Every option that a task has: what else begins with two dashes is somebody's own name.
const std::set<std::string_view>& all_options() {
  static const std::set<std::string_view> names = [] {
    std::set<std::string_view> all;
    const auto add = [&](auto options) {
      for (const Option& option : options_of(options)) all.insert(option.name);
    };
    add(SimulateOptions{});
    add(FitOptions{});
    add(CompareOptions{});
    add(MethodsOptions{});
    add(SweepOptions{});
    add(SpectrumOptions{});
    return all;
  }();
  return names;
}

/// How long the option's name at the start of the text is, behind its two dashes; 0 where there is none.
std::size_t option_at(std::string_view text) {
  if (!text.starts_with("--")) return 0;
  std::size_t end = 2;
  while (end < text.size() && is_of_option(text[end])) ++end;
  while (end > 2 && text[end - 1] == '-') --end;
  return all_options().count(text.substr(2, end - 2)) > 0 ? end - 2 : 0;
}

/// `of_arrays`: forces and motions are given as such, not in columns or files.
std::string as_argument(std::string_view option, bool of_arrays) {
  if (of_arrays && (option == "force-column" || option == "drive-file")) return "force";
  if (of_arrays && option == "base-motion") return "acceleration";
  return argument_of(option);
}

std::string replaced(std::string_view text, char from, char to) {
  std::string out(text);
  std::replace(out.begin(), out.end(), from, to);
  return out;
}

}  // namespace

std::string argument_of(std::string_view option) { return replaced(option, '-', '_'); }
std::string option_of(std::string_view argument) { return replaced(argument, '_', '-'); }

std::string in_arguments(std::string_view text, bool of_arrays) {
  constexpr std::string_view line = "line ";
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = text.substr(i);
    const bool begins = i == 0 || text[i - 1] == ' ' || text[i - 1] == '(' || text[i - 1] == '"';
    if (const std::size_t name = begins ? option_at(rest) : 0; name > 0) {
      out += as_argument(rest.substr(2, name), of_arrays);
      i += 2 + name;
    } else if (of_arrays && begins && rest.starts_with(line) && rest.size() > line.size() &&
               std::isdigit(static_cast<unsigned char>(rest[line.size()]))) {
      out += "sample ";
      i += line.size();
    } else {
      out += text[i++];
    }
  }
  return out;
}

std::vector<std::string> in_arguments(const std::vector<std::string>& texts, bool of_arrays) {
  std::vector<std::string> out;
  for (const std::string& text : texts) out.push_back(in_arguments(text, of_arrays));
  return out;
}

Error in_arguments(const Error& error, bool of_arrays) {
  const std::string_view message = error.message;
  std::string argument = error.argument;
  if (const std::size_t name = option_at(message); argument.empty() && name > 0)
    argument = as_argument(message.substr(2, name), of_arrays);
  // Of arrays what is said of a column is said of one of them.
  for (const std::string_view array : {"force", "y"})
    if (of_arrays && argument.empty() &&
        message.find("column \"" + std::string(array)) != std::string_view::npos)
      argument = array;
  return {in_arguments(message, of_arrays), argument};
}

}  // namespace cromer::core
