#include "cromer/tasks/methods/method_effect.h"

#include <cmath>

#include "cromer/methods/all.h"

namespace cromer::core {
namespace {

/// Angular frequency of the free motion; empty if it does not oscillate.
std::optional<double> free_frequency(const LinearLaw<double>& law) {
  const double w = damped_frequency(law);
  return w > 0 ? std::optional(w) : std::nullopt;
}

/// Equal to four digits; a rate, to a ten-millionth of the frequency.
bool keeps(double effective, double true_value, double frequency) {
  return std::abs(effective - true_value) <= 5e-5 * std::abs(true_value) + 1e-7 * frequency;
}

Notice damping_notice(double effective, double b, double frequency) {
  const bool grows = effective < 0;
  if (b == 0) {
    if (keeps(effective, b, frequency)) return Notice{"adds_no_damping"};
    return Notice{grows ? "adds_growth" : "adds_damping", {{"rate", std::abs(effective)}}};
  }
  const bool law_grows = b < 0;
  const double rate = std::abs(b), simulated = std::abs(effective);
  if (keeps(effective, b, frequency))
    return Notice{law_grows ? "keeps_growth" : "keeps_damping", {{"rate", rate}}};
  constexpr double nearly = 0.01;
  if (std::abs(effective / b - 1) <= nearly)
    return Notice{law_grows ? "keeps_growth_nearly" : "keeps_damping_nearly",
                  {{"rate", rate}, {"simulated", simulated}}};
  const char* const turns[2][2] = {{"turns_damping_into", "turns_damping_into_growth"},
                                   {"turns_growth_into_damping", "turns_growth_into"}};
  return Notice{turns[law_grows][grows], {{"rate", rate}, {"simulated", simulated}}};
}

Notice frequency_notice(double effective, double frequency) {
  if (keeps(effective, frequency, 0)) return Notice{"keeps_frequency", {{"frequency", frequency}}};
  const double off = effective / frequency - 1;
  return Notice{off > 0 ? "swings_too_fast" : "swings_too_slow",
                {{"frequency", effective}, {"percent", 100 * std::abs(off)}}};
}

/// For a motion with real eigenvalues.
Notice without_swing(const MethodEffect& effect, bool law_swings) {
  const bool hops = effect.effective.eigenvalues.front().re < 0;
  if (!effect.stable) return Notice{hops ? "grows_hopping" : "grows_without_swinging"};
  if (hops) return Notice{"dies_down_hopping"};
  return Notice{law_swings ? "creeps_unlike_the_law" : "creeps_as_the_law"};
}

}  // namespace

std::optional<MethodEffect> method_effect(std::string_view method, const MethodSettings& settings,
                                          const LinearLaw<double>& law, double h, bool with_limit) {
  if (find_method(method)->is_adaptive()) return std::nullopt;
  return effect_at_step(method, settings, law, h, with_limit);
}

std::optional<MethodEffect> effect_at_step(std::string_view method, const MethodSettings& settings,
                                           const LinearLaw<double>& law, double h, bool with_limit) {
  MethodEffect result;
  result.effective = effective_oscillator_of(method, settings, law, h);
  result.stable = result.effective.stable();
  // A law that grows by itself is to grow at any step.
  if (law.stiffness > 0 && law.decay_rate >= 0 && (with_limit || !result.stable)) {
    const LinearLaw<double> free{.decay_rate = law.decay_rate, .stiffness = law.stiffness};
    result.stability_limit = first_unstable_step(free, [&](double step) {
      return effective_oscillator_of(method, settings, free, step).spectral_radius;
    });
    // If every step is stable, a radius above 1 is rounding.
    result.stable = result.stable || !result.stability_limit;
  }
  if (std::isnan(result.effective.spectral_radius)) return std::nullopt;
  if (method == "exact") {
    // Also if the step is too long to show the frequency.
    result.effective.angular_frequency = free_frequency(law);
    result.effective.decay_rate =
        result.effective.angular_frequency ? std::optional(law.decay_rate) : std::nullopt;
  }
  return result;
}

Notice effect_notice(const MethodEffect& effect, const LinearLaw<double>& law) {
  const auto frequency = free_frequency(law);
  const EffectiveOscillator& effective = effect.effective;
  if (!effective.decay_rate || !effective.angular_frequency)
    return without_swing(effect, frequency.has_value());
  if (!frequency) return Notice{"swings_unlike_the_law", {{"frequency", *effective.angular_frequency}}};
  if (law.decay_rate > 0 && keeps(*effective.decay_rate, law.decay_rate, *frequency) &&
      keeps(*effective.angular_frequency, *frequency, 0))
    return Notice{"keeps_damping_and_frequency", {{"rate", law.decay_rate}, {"frequency", *frequency}}};
  return Notice{"damping_and_frequency",
                {{"damping", damping_notice(*effective.decay_rate, law.decay_rate, *frequency)},
                 {"frequency", frequency_notice(*effective.angular_frequency, *frequency)}}};
}

Notice instability_notice(std::string_view method, const MethodEffect& effect, double h,
                          const Notice& motions) {
  if (effect.stable || !effect.stability_limit) return {};
  const double limit = *effect.stability_limit;
  if (motions.empty()) {
    if (limit == 0) return Notice{"unstable_at_any_step", {{"method", method}}};
    return Notice{"step_beyond_stability", {{"step", h}, {"method", method}, {"limit", limit}}};
  }
  if (limit == 0) return Notice{"motions_unstable_at_any_step", {{"method", method}, {"motions", motions}}};
  return Notice{"step_beyond_stability_of_motions",
                {{"step", h}, {"method", method}, {"motions", motions}, {"limit", limit}}};
}

}  // namespace cromer::core
