#include "cromer/tasks/sweep/sweep_description.h"

#include <fmt/format.h>

#include <algorithm>

#include "cromer/base/quantity.h"
#include "cromer/methods/all.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

bool is_swept(const SweepWork& work, std::string_view option) {
  return std::any_of(work.axes.begin(), work.axes.end(),
                     [&](const SweepAxis& axis) { return axis.name == option; });
}

std::string step_in_words(const SweepWork& work) {
  const MethodInfo& info = *find_method(work.method);
  const bool takes_none = info.order == 0 && work.way == SweepWay::closed_form;
  if (takes_none || info.error_order > 0 || is_swept(work, "step")) return "";
  if (work.base.step) return fmt::format("steps of {} s", shortest(*work.base.step));
  return fmt::format("{:g} steps in {}", default_steps_per_period,
                     work.driven ? "a natural or a drive period, whichever is shorter" : "a natural period");
}

std::string end_in_words(const SweepWork& work) {
  if (!work.runs_to_end() || is_swept(work, "until")) return "";
  if (work.base.until) return fmt::format("to {} s", shortest(*work.base.until));
  return fmt::format("for {:g} natural periods", default_periods);
}

}  // namespace

std::string_view words(SweepWay way) {
  switch (way) {
    case SweepWay::closed_form:
      return "closed form";
    case SweepWay::settled:
      return "stepped until settled";
    case SweepWay::to_end:
      return "stepped to the end";
    case SweepWay::one_by_one:
      return "run one by one";
  }
  return "";
}

std::string describe(const SweepOptions& options, const SweepWork& work, const MethodSettings& settings,
                     const SweepPlan& plan) {
  std::string text = fmt::format("{{\"method\": \"{}\", \"way\": \"{}\", \"direction\": \"{}\"", work.method,
                                 words(work.way), options.direction);
  if (work.way == SweepWay::settled || work.way == SweepWay::to_end)
    text += fmt::format(", \"simd\": \"{}\"", work.unit.name);
  if (options.settle) text += fmt::format(", \"settle\": {}", shortest(*options.settle));
  text += fmt::format(", \"tolerance\": {}, \"beta\": {}, \"gamma\": {}, \"rho_inf\": {}",
                      shortest(settings.newton.tolerance), shortest(settings.beta), shortest(settings.gamma),
                      shortest(settings.rho_inf));
  if (!is_swept(work, "step") && !work.base.step)
    text += fmt::format(", \"steps_per_period\": {:g}", default_steps_per_period);
  if (work.runs_to_end() && !work.base.until) text += fmt::format(", \"periods\": {:g}", default_periods);
  if (!work.base.drive.empty()) text += fmt::format(", \"drive\": \"{}\"", work.base.drive);
  for (const auto& [name, value] : options.values)
    if (!value.empty()) text += fmt::format(", \"{}\": \"{}\"", name, value);
  text += ", \"columns\": [";
  for (std::size_t i = 0; i < plan.rows.columns.size(); ++i)
    text += fmt::format("{}\"{}\"", i ? ", " : "", plan.rows.columns[i]);
  return text + "]}";
}

std::string steps_in_words(const SweepWork& work) {
  const std::string step = step_in_words(work), end = end_in_words(work);
  return step + (step.empty() || end.empty() ? "" : ", ") + end;
}

}  // namespace cromer::core
