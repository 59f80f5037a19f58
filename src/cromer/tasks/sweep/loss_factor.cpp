// Hysteretic damping in a sweep: a spring k (1 + i eta), which has a meaning in steady states only.
#include "cromer/tasks/sweep/sweep_rows.h"

#include <string_view>
#include <vector>

#include "cromer/model/law.h"

namespace cromer::core {

bool has_loss_factor(const SweepOptions& options) {
  const auto typed = options.values.find("loss-factor");
  return typed != options.values.end() && !typed->second.empty();
}

Result<void> check_loss_factor(const SweepOptions& options, const SweepWork& work) {
  if (!has_loss_factor(options)) return {};
  const auto refuse = [](std::string_view other) {
    return Error{"loss_factor_in_closed_form", {{"option", other}}};
  };
  std::vector<std::string_view> others{"damping", "damping-ratio", "quality-factor", "static-friction",
                                       "until"};
  for_each_term([&]<class T>() {
    if constexpr (!linear_terms.has<T>())
      for (const CoefficientInfo& each : T::coefficients) others.push_back(each.option);
  });
  for (const std::string_view other : others) {
    const auto typed = options.values.find(other);
    if (typed != options.values.end() && !typed->second.empty()) return refuse(other);
  }
  if (options.settle) return refuse("settle");
  if (!options.direction.empty()) return refuse("direction");
  if (options.check) return refuse("check");
  if (work.base.drive == "base") return Error{"loss_factor_of_base"};
  if (work.method != "exact") return Error{"loss_factor_not_stepped", {{"method", work.method}}};
  return {};
}

Result<void> check_settled_loss(const SweepOptions& options, const SweepWork& work) {
  if (!has_loss_factor(options)) return {};
  if (!work.driven) return Error{"loss_factor_undriven"};
  for (const Measure* measure : work.measures)
    if (!measure->in_closed_form) return Error{"loss_factor_measure", {{"measure", measure->name}}};
  return {};
}

}  // namespace cromer::core
