#include "cromer/tasks/curves/method_map.h"

#include <cmath>
#include <limits>
#include "cromer/model/linear_quantities.h"

#include "cromer/methods/all.h"
#include "cromer/model/law_force.h"
#include "cromer/tasks/methods/method_effect.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

MethodMapPoint point_of(const std::optional<MethodEffect>& effect, const LinearLaw<double>& law) {
  if (!effect || !effect->effective.angular_frequency) return {nothing, nothing, nothing, nothing};
  const double w = std::sqrt(law.stiffness);
  const double decay_rate = *effect->effective.decay_rate;
  return {decay_rate, std::abs(*effect->effective.angular_frequency / damped_frequency(law) - 1),
          std::abs(decay_rate - law.decay_rate) / w, *effect->effective.energy_factor()};
}

MethodMapCurve curve_of(const SimulatedRun& run, const LinearLaw<double>& law,
                        const MethodMapOptions& options) {
  const double w = std::sqrt(law.stiffness);
  const auto effect_at = [&](double wh, bool with_limit) {
    return effect_at_step(run.method, run.settings, law, wh / w, with_limit);
  };
  MethodMapCurve curve;
  curve.method = run.method;
  curve.order = find_method(run.method)->order;
  for (long long i = 0; i < options.points; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(options.points - 1);
    curve.wh.push_back(options.from * std::pow(options.to / options.from, share));
    curve.at.push_back(point_of(effect_at(curve.wh.back(), false), law));
  }
  const auto tenth = effect_at(0.1, true);
  curve.at_a_tenth = point_of(tenth, law);
  if (tenth && tenth->stability_limit) curve.stable_up_to = *tenth->stability_limit * w;
  return curve;
}

}  // namespace

Result<MethodMapResult> method_map(const MethodMapOptions& options) {
  if (!(options.from > 0)) return Error{"from_not_positive"};
  if (!(options.to > options.from)) return Error{"to_not_above_from"};
  if (options.points < 2) return Error{"too_few_points"};
  const auto runs = set_up_runs(options.simulate);
  if (!runs) return runs.error();
  const Oscillator<double>& o = runs->front().oscillator;
  if (const std::string_view term = why_not_exact(o); !term.empty())
    return Error{"method_map_not_linear", {{"option", term}}};
  const LinearLaw<double> law = linear_law(o);
  if (!(law.stiffness > law.decay_rate * law.decay_rate)) return Error{"law_does_not_oscillate"};
  MethodMapResult result{std::sqrt(law.stiffness), law.decay_rate, {}};
  for (const SimulatedRun& run : *runs) result.curves.push_back(curve_of(run, law, options));
  return result;
}

}  // namespace cromer::core
