#include "cromer/study/task/derived_quantities.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "cromer/analysis/amplitude_decay.h"
#include "cromer/analysis/swing.h"
#include "cromer/base/dual.h"
#include "cromer/identify/describe_fit.h"

namespace cromer {
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

Estimate estimate_of(const Real& number, const LawFit& fit) {
  const std::size_t n = fit.names.size();
  double variance = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      variance += number.derivative[i] * fit.covariance[i * n + j] * number.derivative[j];
  return make_estimate(number.value, std::sqrt(std::max(0.0, variance)), fit.student);
}

std::vector<NamedEstimate> at_amplitude(LawAtAmplitude law, const Real& A, const LawFit& fit,
                                        const std::string& unit) {
  const Real undamped = law.swing.angular_frequency(A);
  law.decay.angular_frequency = undamped;
  const Real g = 0.5 * law.decay.per_mass.damping, equivalent = law.decay.rate(A);
  const Real w = sqrt(undamped * undamped - g * g);
  const Real period = 2 * std::numbers::pi / w;
  std::vector<NamedEstimate> list{{"frequency", estimate_of(1 / period, fit), "Hz"},
                                  {"period", estimate_of(period, fit), "s"},
                                  {"damping_ratio", estimate_of(equivalent / undamped, fit), "1"}};
  const bool fed = value_of(g) < 0;
  if (!fed) list.push_back({"quality_factor", estimate_of(undamped / (2 * equivalent), fit), "1"});
  list.push_back({"logarithmic_decrement", estimate_of(equivalent * period, fit), "1"});
  list.push_back({"at_amplitude", estimate_of(A, fit), unit});
  if (fed)
    if (const std::optional<Real> limit = law.decay.limit_amplitude(value_of(A)))
      list.push_back({"limit_cycle_amplitude", estimate_of(*limit, fit), unit});
  return list;
}

}  // namespace

std::vector<NamedEstimate> derived_quantities(const LawFit& fit, std::string_view observed, int derivative,
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
  std::vector<NamedEstimate> list = at_amplitude(law, Real(sinusoid_amplitude(x)), fit, length);
  if (fit.motion.decay_rate() >= fit.motion.angular_frequency())
    list.erase(std::remove_if(list.begin(), list.end(),
                              [](const NamedEstimate& number) {
                                return number.name == "frequency" || number.name == "period" ||
                                       number.name == "logarithmic_decrement";
                              }),
               list.end());
  return list;
}

}  // namespace cromer
