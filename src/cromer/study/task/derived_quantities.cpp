#include "cromer/study/task/derived_quantities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cromer/analysis/amplitude_decay.h"
#include "cromer/analysis/swing.h"
#include "cromer/base/dual.h"

namespace cromer {
namespace {

constexpr std::array<std::string_view, 8> of_the_law{
    "angular_frequency", "decay_rate", "drag", "friction", "cubic", "quadratic", "position", "velocity"};
using Real = Dual<double, of_the_law.size()>;

/// The law over numbers that carry their derivatives by its own parameters.
struct LawAtAmplitude {
  Swing<Real> swing;
  CycleDecay<Real> decay;
  Real position, velocity;
};

LawAtAmplitude law_of(const FreeDecay& fit, const std::optional<Estimate>& quadratic) {
  const auto variable = [&](std::size_t i, const std::optional<Estimate>& estimate) {
    return estimate ? Real::variable(estimate->value, i) : Real(0);
  };
  LawAtAmplitude law;
  const Real w0 = variable(0, fit.angular_frequency);
  law.decay = {.decay_rate = variable(1, fit.decay_rate),
               .drag = variable(2, fit.drag),
               .friction = variable(3, fit.friction)};
  law.swing = {.stiffness = w0 * w0,
               .quadratic = variable(5, quadratic),
               .cubic = variable(4, fit.cubic),
               .pendulum = fit.law.pendulum};
  law.position = variable(6, fit.position);
  law.velocity = variable(7, fit.velocity);
  return law;
}

Estimate estimate_of(const Real& number, const FreeDecay& fit) {
  double variance = 0;
  for (std::size_t i = 0; i < of_the_law.size(); ++i)
    for (std::size_t j = 0; j < of_the_law.size(); ++j)
      if (const double c = fit.covariance_of(of_the_law[i], of_the_law[j]); c != 0)
        variance += number.derivative[i] * c * number.derivative[j];
  return make_estimate(number.value, std::sqrt(std::max(0.0, variance)), fit.student);
}

std::vector<NamedEstimate> at_amplitude(LawAtAmplitude law, const Real& A, const FreeDecay& fit,
                                        std::string unit) {
  const Real undamped = law.swing.angular_frequency(A);
  law.decay.angular_frequency = undamped;
  const Real g = law.decay.decay_rate, equivalent = law.decay.rate(A);
  const Real w = sqrt(undamped * undamped - g * g);
  const Real period = 2 * std::numbers::pi / w;
  return {{"frequency", estimate_of(1 / period, fit), "Hz"},
          {"period", estimate_of(period, fit), "s"},
          {"damping_ratio", estimate_of(equivalent / undamped, fit), "1"},
          {"quality_factor", estimate_of(undamped / (2 * equivalent), fit), "1"},
          {"logarithmic_decrement", estimate_of(equivalent * period, fit), "1"},
          {"at_amplitude", estimate_of(A, fit), std::move(unit)}};
}

/// Of the sinusoid with the root mean square of these numbers about their mean.
double mean_amplitude(const std::vector<double>& motion) {
  double mean = 0, square = 0;
  for (const double x : motion) mean += x / static_cast<double>(motion.size());
  for (const double x : motion) square += (x - mean) * (x - mean) / static_cast<double>(motion.size());
  return std::sqrt(2 * square);
}

}  // namespace

std::vector<NamedEstimate> derived_quantities(const FreeDecay& fit, std::string_view observed,
                                              int derivative) {
  const LawAtAmplitude law = law_of(fit, std::nullopt);
  return at_amplitude(law, law.swing.amplitude(law.position, law.velocity), fit,
                      displacement_unit(observed, derivative));
}

std::vector<NamedEstimate> derived_quantities(const ForcedFit& fit, std::string_view observed,
                                              int derivative) {
  std::vector<NamedEstimate> list =
      at_amplitude(law_of(fit.law, fit.quadratic), Real(mean_amplitude(fit.states.x)), fit.law,
                   displacement_unit(observed, derivative));
  if (fit.law.decay_rate.value >= fit.law.angular_frequency.value)
    list.erase(std::remove_if(list.begin(), list.end(),
                              [](const NamedEstimate& number) {
                                return number.name == "frequency" || number.name == "period" ||
                                       number.name == "logarithmic_decrement";
                              }),
               list.end());
  return list;
}

}  // namespace cromer
