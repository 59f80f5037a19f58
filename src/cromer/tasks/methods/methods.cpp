#include "cromer/tasks/methods/methods.h"

#include <fmt/format.h>

#include "cromer/methods/all.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {
namespace {

Result<void> check_options(MethodsOptions options) {
  for (const auto& option : options_of(options))
    if (auto good = check(option); !good) return good;
  if (options.natural_frequency && !options.step) return Error{"natural_frequency_needs_step"};
  if (options.step && !options.natural_frequency) return Error{"step_needs_natural_frequency"};
  if (!options.step && (options.damping_ratio || options.beta || options.gamma || options.rho_inf))
    return Error{"option_needs_frequency_and_step",
                 {{"option", options.damping_ratio ? "damping-ratio"
                             : options.rho_inf     ? "rho-inf"
                             : options.beta        ? "beta"
                                                   : "gamma"}}};
  return {};
}

std::string order_text(const MethodInfo& info) {
  if (info.is_exact()) return "exact";
  return info.is_adaptive() ? fmt::format("{}({})", info.order, info.error_order)
                            : fmt::format("{}", info.order);
}

}  // namespace

Result<std::vector<MethodRow>> list_methods(const MethodsOptions& options) {
  if (auto good = check_options(options); !good) return good.error();
  std::vector<MethodRow> rows;
  for (const MethodInfo& info : method_infos)
    rows.push_back({.name = info.name,
                    .order = info.is_exact() ? std::nullopt : std::optional<int>(info.order),
                    .order_text = order_text(info),
                    .implicit = info.implicit,
                    .symplectic = info.symplectic,
                    .adaptive = info.is_adaptive(),
                    .reversible = info.reversible,
                    .a_stable = info.a_stable,
                    .source = info.source});
  if (!options.step) return rows;

  const double w = *options.natural_frequency;
  const LinearLaw<double> law{.decay_rate = options.damping_ratio.value_or(0) * w, .stiffness = w * w};
  MethodSettings settings;
  settings.beta = options.beta.value_or(settings.beta);
  settings.gamma = options.gamma.value_or(settings.gamma);
  settings.rho_inf = options.rho_inf.value_or(settings.rho_inf);
  for (auto& row : rows) {
    row.effect = method_effect(row.name, settings, law, *options.step, true);
    if (!row.effect) continue;
    row.words = effect_notice(*row.effect, law);
    if (row.effect->stable && row.effect->stability_limit && *options.step > *row.effect->stability_limit)
      row.words = Notice{"grows_at_shorter_steps", {{"what", row.words}}};
  }
  return rows;
}

std::string methods_in_markdown() {
  const auto yes = [](bool is) { return is ? "yes" : ""; };
  std::string text =
      "| method | order | implicit | symplectic | reversible | A-stable | evaluations a step | source |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const MethodInfo& info : method_infos) {
    const std::string evaluations = !info.implicit
                                        ? fmt::format("{}", info.evaluations)
                                        : fmt::format("{} an iteration", info.iteration_evaluations);
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", info.name, order_text(info),
                        yes(info.implicit), yes(info.symplectic), yes(info.reversible), yes(info.a_stable),
                        evaluations, info.source);
  }
  return text;
}

}  // namespace cromer::core
