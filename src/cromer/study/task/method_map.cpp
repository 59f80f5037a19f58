#include "cromer/study/task/method_map.h"

#include <cmath>
#include <limits>

#include "cromer/methods/all.h"
#include "cromer/model/terms.h"
#include "cromer/study/task/method_effect.h"
#include "cromer/study/task/simulate_setup.h"

namespace cromer {
namespace {

MethodMapCurve curve_of(const std::string& method, const LinearLaw<double>& law,
                        const MethodMapOptions& options) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const double w = std::sqrt(law.stiffness);
  const double damped = std::sqrt(law.stiffness - law.decay_rate * law.decay_rate);
  MethodMapCurve curve;
  curve.method = method;
  for (long long i = 0; i < options.points; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(options.points - 1);
    const double wh = options.from * std::pow(options.to / options.from, share);
    const auto effect = method_effect(method, {}, law, wh / w, false);
    const bool swings = effect && effect->effective.angular_frequency;
    const double frequency = swings ? *effect->effective.angular_frequency : nothing;
    const double decay_rate = swings ? *effect->effective.decay_rate : nothing;
    curve.wh.push_back(wh);
    curve.decay_rate.push_back(decay_rate);
    curve.frequency_error.push_back(std::abs(frequency / damped - 1));
    curve.decay_error.push_back(std::abs(decay_rate - law.decay_rate) / w);
  }
  return curve;
}

}  // namespace

Result<MethodMapResult> method_map(const MethodMapOptions& options) {
  if (!(options.from > 0)) return Error{"--from: it must be positive"};
  if (!(options.to > options.from)) return Error{"--to: it must be above --from"};
  if (options.points < 2) return Error{"--points: at least 2"};
  const auto runs = set_up_runs(options.simulate);
  if (!runs) return runs.error();
  const Oscillator<double>& o = runs->front().oscillator;
  if (const std::string_view term = why_not_exact(o); !term.empty())
    return Error{"--" + std::string(term) + ": only a linear law has one frequency and one decay rate"};
  const LinearLaw<double> law{.decay_rate = o.damping / (2 * o.mass), .stiffness = o.stiffness / o.mass};
  if (!(law.stiffness > law.decay_rate * law.decay_rate))
    return Error{"--damping: this law does not oscillate"};
  MethodMapResult result{std::sqrt(law.stiffness), law.decay_rate, {}};
  for (const SimulatedRun& run : *runs) {
    if (find_method(run.method)->error_order > 0)
      return Error{"--method: " + run.method + " chooses its own steps"};
    result.curves.push_back(curve_of(run.method, law, options));
  }
  return result;
}

}  // namespace cromer
