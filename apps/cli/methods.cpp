#include <fmt/format.h>

#include "commands.h"
#include "cromer/study/json/documents.h"
#include "cromer/study/task/methods.h"
#include "exit_status.h"
#include "message.h"
#include "output.h"
#include "syntax.h"
#include "text_table.h"

namespace cromer::cli {
namespace {

std::string table(const std::vector<MethodRow>& methods) {
  const auto yes = [](bool is) { return std::string(is ? "yes" : "no"); };
  std::vector<std::vector<std::string>> rows{
      {"method", "order", "implicit", "symplectic", "adaptive", "source"}};
  for (const auto& method : methods)
    rows.push_back({std::string(method.name), method.order ? fmt::format("{}", *method.order) : "exact",
                    yes(method.implicit), yes(method.symplectic), yes(method.adaptive),
                    std::string(method.source)});
  return text_table(rows, 1, 2) + "\"Symplectic\" is said of the undamped law.\n";
}

}  // namespace

int run_methods(const Arguments& arguments) {
  OutputOptions output;
  Syntax syntax{
      .command = "methods",
      .description =
          "The methods of integration: their names as --method takes them, their orders and sources.",
      .files = "",
      .options = {},
      .example = "  cromer methods --json"};
  add_output_options(syntax.options, output, {.files = false, .plot = false}, "");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  const auto methods = list_methods();
  return print(output.json ? to_json(methods) : table(methods)) ? done
                                                                : refuse("standard output cannot be written");
}

}  // namespace cromer::cli
