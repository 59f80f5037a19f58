#include "cromer/study/task/methods.h"

#include <fmt/format.h>

#include "commands.h"
#include "cromer/study/json/documents.h"
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
      {"method", "order", "implicit", "symplectic", "reversible", "A-stable", "adaptive", "source"}};
  for (const auto& method : methods)
    rows.push_back({std::string(method.name), method.order ? fmt::format("{}", *method.order) : "exact",
                    yes(method.implicit), yes(method.symplectic), yes(method.reversible),
                    yes(method.a_stable), yes(method.adaptive), std::string(method.source)});
  return text_table(rows, 1, 2) + "\"Symplectic\" is said of the undamped law.\n";
}

std::string number(const std::optional<double>& value, const char* otherwise = "") {
  return value ? fmt::format("{:.6g}", *value) : otherwise;
}

std::string effects(const std::vector<MethodRow>& methods) {
  std::vector<std::vector<std::string>> rows{{"method", "decay rate (1/s)", "frequency (rad/s)",
                                              "energy/cycle", "stable up to (s)", "stable", "in words"}};
  for (const auto& method : methods) {
    if (!method.effect) {
      rows.push_back({std::string(method.name), "", "", "", "", "",
                      method.adaptive ? "chooses its own steps" : "finds no solution of its equation"});
      continue;
    }
    const EffectiveOscillator& effective = method.effect->effective;
    rows.push_back({std::string(method.name), number(effective.decay_rate),
                    number(effective.angular_frequency), number(effective.energy_factor()),
                    number(method.effect->stability_limit, "any"), method.effect->stable ? "yes" : "no",
                    method.words});
  }
  return text_table(rows, 1, 5);
}

}  // namespace

int run_methods(const Arguments& arguments) {
  MethodsOptions options;
  OutputOptions output;
  Syntax syntax{
      .command = "methods",
      .description =
          "The methods of integration: their names as --method takes them, their orders and sources; with a "
          "step, what each of them really simulates.",
      .files = "",
      .options = options_of(options),
      .example = "  cromer methods --natural-frequency 6 --damping-ratio 0.025 --step 0.01"};
  add_output_options(syntax.options, output, {.files = false, .plot = false}, "");
  std::vector<std::string> files;
  if (const auto status = parse(syntax, arguments, files)) return *status;
  if (options.markdown)
    return print(methods_in_markdown()) ? done : refuse("standard output cannot be written");
  const auto methods = list_methods(options);
  if (!methods) return refuse(methods.error().message);
  return print(output.json    ? to_json(*methods)
               : options.step ? effects(*methods)
                              : table(*methods))
             ? done
             : refuse("standard output cannot be written");
}

}  // namespace cromer::cli
