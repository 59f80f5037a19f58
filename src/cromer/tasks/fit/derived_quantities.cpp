#include "cromer/tasks/fit/derived_quantities.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "cromer/analysis/swing.h"
#include "cromer/base/dual.h"
#include "cromer/identify/diagnose/mean_decay.h"
#include "cromer/identify/record.h"

namespace cromer::core {
namespace {

using Real = Dual<double, max_parameters>;

/// The law over numbers that carry their derivatives by its own parameters.
struct LawAtAmplitude {
  Swing<Real> swing;
  CycleDecay<Real> decay;
  Real position, velocity;
};

LawAtAmplitude law_at_amplitude(const LawFit& fit) {
  const auto variable = [&](std::string_view name) {
    const auto i =
        static_cast<std::size_t>(std::find(fit.names.begin(), fit.names.end(), name) - fit.names.begin());
    return i < fit.names.size() ? Real::variable(fit.estimates[i].value, i) : Real(0.0);
  };
  LawAtAmplitude law;
  Oscillator<Real>& per_mass = law.swing.per_mass;
  per_mass.stiffness = Real(0.0);
  for_each_term([&]<class T>() {
    if (!fit.law.has<T>()) return;
    for (std::size_t i = 0; i < coefficients_of<T>; ++i) {
      const CoefficientInfo& info = T::coefficients[i];
      per_mass.*T::template members<Real>[i] = from_fitted(info.fitted, variable(info.parameter));
    }
  });
  law.decay.per_mass = per_mass;
  law.position = variable("position");
  law.velocity = variable("velocity");
  return law;
}

Estimate estimate_of(double value, std::span<const double> slope, const LawFit& fit) {
  const std::size_t n = fit.names.size();
  double variance = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) variance += slope[i] * fit.covariance[i * n + j] * slope[j];
  return make_estimate(value, std::sqrt(std::max(0.0, variance)), fit.student);
}

Estimate estimate_of(const Real& number, const LawFit& fit) {
  return estimate_of(number.value, number.derivative, fit);
}

// Where something surely feeds the swing, and something surely bounds it. By differences: the cycle has no
// closed form.
std::optional<Estimate> limit_cycle(const LawFit& fit, double near, double period) {
  const Estimate* bound = fit.find(VanDerPol::coefficients[0].parameter);
  if (!is_fed(fit) || !bound || !(bound->low > 0)) return std::nullopt;
  const FittedParameters fitted = fitted_parameters(fit.law, fit.drive.kind, {}, fit.motion);
  const auto value = limit_cycle_amplitude(fit.motion.per_mass, near, period);
  if (!value) return std::nullopt;
  std::vector<double> slope(fit.names.size(), 0.0);
  for (std::size_t i = 0; i < fit.names.size(); ++i) {
    const int place = fitted.place_of(fit.names[i]);
    const double step = 0.1 * fit.estimates[i].standard_error;
    if (place < 0 || !fitted.of[place].coefficient || !(step > 0)) continue;
    Motion motion = fit.motion;
    fitted.of[place].set(motion, fit.estimates[i].value + step);
    if (const auto moved = limit_cycle_amplitude(motion.per_mass, *value, period))
      slope[i] = (*moved - *value) / step;
  }
  return estimate_of(*value, slope, fit);
}

std::vector<Parameter> at_amplitude(LawAtAmplitude law, const Real& A, const LawFit& fit,
                                    const std::string& unit) {
  const Real undamped = law.swing.angular_frequency(A);
  law.decay.angular_frequency = undamped;
  const Real g = 0.5 * law.decay.per_mass.damping, equivalent = law.decay.rate(A);
  const Real w = sqrt(undamped * undamped - g * g);
  const Real period = 2 * std::numbers::pi / w;
  std::vector<Parameter> list{{"frequency", estimate_of(1 / period, fit), "Hz"},
                              {"period", estimate_of(period, fit), "s"},
                              {"damping_ratio", estimate_of(equivalent / undamped, fit), "1"}};
  // What is fed, or grows, has no quality factor.
  const bool fed = value_of(g) < 0;
  if (!fed && !(value_of(equivalent) < 0))
    list.push_back({"quality_factor", estimate_of(undamped / (2 * equivalent), fit), "1"});
  list.push_back({"logarithmic_decrement", estimate_of(equivalent * period, fit), "1"});
  list.push_back({"at_amplitude", estimate_of(A, fit), unit});
  if (const auto limit = limit_cycle(fit, value_of(A), value_of(period)))
    list.push_back({"limit_cycle_amplitude", *limit, unit});
  return list;
}

// What an overdamped motion, which has no cycle, does not have.
constexpr std::string_view no_cycle[] = {"frequency", "period", "logarithmic_decrement"};

}  // namespace

std::vector<Parameter> derived_quantities(const LawFit& fit, std::string_view observed, int derivative,
                                          const std::vector<double>& x, std::string_view force_unit) {
  const std::string length = displacement_unit(observed, derivative);
  if (!fit.law.shares(springs)) {
    const Estimate gain = fit["force_gain"];
    const double mass = 1 / gain.value, error = gain.standard_error / (gain.value * gain.value);
    const bool newtons = force_unit == "N" && length == "m";
    return {{"mass", make_estimate(mass, error, fit.student), newtons ? "kg" : ""}};
  }
  if (fit.law.has<Hysteresis>()) return {};
  const LawAtAmplitude law = law_at_amplitude(fit);
  if (fit.drive.kind == DriveKind::none)
    return at_amplitude(law, law.swing.amplitude(law.position, law.velocity), fit, length);
  std::vector<Parameter> list = at_amplitude(law, Real(sinusoid_amplitude(x)), fit, length);
  if (fit.motion.decay_rate() >= fit.motion.angular_frequency())
    std::erase_if(list, [](const Parameter& number) {
      return std::find(std::begin(no_cycle), std::end(no_cycle), number.name) != std::end(no_cycle);
    });
  return list;
}

}  // namespace cromer::core
