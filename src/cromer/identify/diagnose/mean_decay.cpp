#include "cromer/identify/diagnose/mean_decay.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cromer/analysis/swing.h"
#include "cromer/base/quantity.h"
#include "cromer/identify/motion/parameter_unit.h"

namespace cromer::core {
namespace {

// Each term that takes energy, by its parameter, with the rate that a unit of it makes.
std::vector<std::pair<std::string_view, double>> parts_of(const LawFit& fit, double amplitude) {
  std::vector<std::pair<std::string_view, double>> parts;
  for_each_term([&]<class T>() {
    if constexpr (!HasInnerState<T>) {
      if (!fit.law.has<T>() || springs.has<T>()) return;
      const CycleAverage<double> average = cycle_average<T>(amplitude, fit.motion.angular_frequency());
      if (std::abs(average.fall) < 1e-9 * std::abs(average.shift) * amplitude) return;
      const double coefficient = from_fitted(T::coefficients[0].fitted, 1.0);
      parts.emplace_back(T::coefficients[0].parameter, coefficient * average.fall / amplitude);
    }
  });
  return parts;
}

}  // namespace

std::optional<MeanDecay> mean_decay(const LawFit& fit, const Record& record) {
  if (fit.law.has<Hysteresis>()) return std::nullopt;
  MeanDecay decay;
  const double w = fit.motion.angular_frequency();
  decay.amplitude = sinusoid_amplitude(record.y) / std::pow(w, record.derivative);
  decay.unit = unit_of_parameter("position", fit.motion, record.unit, record.derivative);
  if (fit.explained > 0) decay.amplitude *= std::sqrt(fit.explained);  // noise is none of it
  const auto parts = parts_of(fit, decay.amplitude);
  double rate = 0, variance = 0;
  for (const auto& [name, per_unit] : parts) {
    rate += per_unit * fit[name].value;
    for (const auto& [other, per_other] : parts)
      variance += per_unit * per_other * fit.covariance_of(name, other);
  }
  // Under a bent spring the amplitude falls by another rate than the energy's half.
  double bent = 1;
  if (Swing<double>{fit.motion.per_mass}.is_bent() && rate != 0) {
    const AmplitudeDecay there{.angular_frequency = w, .per_mass = fit.motion.per_mass};
    if (const double of_amplitude = there.rate(decay.amplitude); std::isfinite(of_amplitude))
      bent = of_amplitude / rate;
  }
  decay.rate = make_estimate(bent * rate, std::abs(bent) * std::sqrt(std::max(0.0, variance)), fit.student);
  return decay;
}

bool dampings_are_collinear(const LawFit& fit) {
  constexpr double collinear = -0.9;
  std::vector<std::string_view> before;
  bool found = false;
  for_each_term([&]<class T>() {
    if (!dampings.has<T>()) return;
    const std::string_view one = T::coefficients[0].parameter;
    for (const std::string_view other : before) {
      const double variances = fit.covariance_of(one, one) * fit.covariance_of(other, other);
      found = found || (variances > 0 && fit.covariance_of(one, other) < collinear * std::sqrt(variances));
    }
    before.push_back(one);
  });
  return found;
}

bool is_fed(const LawFit& fit) {
  const Estimate* viscous = fit.find(Viscous::coefficients[0].parameter);
  return viscous && viscous->high < 0;
}

Notice as_clause(const MeanDecay& decay) {
  return Notice{"mean_decay_rate",
                {{"rate", format_quantity({decay.rate.value, decay.rate.standard_error}, "1/s")},
                 {"amplitude", decay.amplitude},
                 {"unit", decay.unit.empty() ? "" : "\u00a0" + decay.unit}}};
}

}  // namespace cromer::core
