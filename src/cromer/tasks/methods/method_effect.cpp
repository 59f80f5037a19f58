#include "cromer/tasks/methods/method_effect.h"

#include <fmt/format.h>

#include <cmath>

#include "cromer/base/quantity.h"
#include "cromer/methods/all.h"

namespace cromer::core {
namespace {

/// Angular frequency of the free motion; empty if it does not swing.
std::optional<double> free_frequency(const LinearLaw<double>& law) {
  const double squared = law.stiffness - law.decay_rate * law.decay_rate;
  return squared > 0 ? std::optional(std::sqrt(squared)) : std::nullopt;
}

/// Equal to four digits or, of a rate, to a ten-millionth of the frequency.
bool keeps(double effective, double true_value, double frequency) {
  return std::abs(effective - true_value) <= 5e-5 * std::abs(true_value) + 1e-7 * frequency;
}

std::string damping_in_words(double effective, double b, double frequency) {
  if (b == 0) {
    if (keeps(effective, b, frequency)) return "adds no damping";
    return fmt::format("adds {} of {:.4g} 1/s", effective < 0 ? "growth" : "damping", std::abs(effective));
  }
  if (keeps(effective, b, frequency)) return fmt::format("keeps your damping of {:.4g} 1/s", b);
  constexpr double nearly = 0.01;
  if (std::abs(effective / b - 1) <= nearly)
    return fmt::format("keeps your damping of {:.4g} 1/s nearly ({:.4g})", b, effective);
  return fmt::format("turns your damping of {:.4g} 1/s into {}{:.4g} 1/s", b,
                     effective < 0 ? "growth of " : "", std::abs(effective));
}

std::string frequency_in_words(double effective, double frequency) {
  if (keeps(effective, frequency, 0)) return fmt::format("keeps your {:.6g} rad/s", frequency);
  const double off = effective / frequency - 1;
  return fmt::format("swings at {:.6g} rad/s, {:.2g} % too {}", effective, 100 * std::abs(off),
                     off > 0 ? "fast" : "slow");
}

/// Of a motion with real eigenvalues.
std::string without_swing(const MethodEffect& effect, bool law_swings) {
  const bool hops = effect.effective.eigenvalues.front().re < 0;
  if (!effect.stable) return hops ? "grows, with another sign each step" : "grows without swinging";
  if (hops) return "dies down with another sign each step, which your law does not";
  return law_swings ? "creeps back without swinging, where your law swings"
                    : "creeps back without swinging, as your law does";
}

}  // namespace

std::optional<MethodEffect> method_effect(std::string_view method, const MethodSettings& settings,
                                          const LinearLaw<double>& law, double h, bool with_limit) {
  if (find_method(method)->error_order > 0) return std::nullopt;
  return effect_at_step(method, settings, law, h, with_limit);
}

std::optional<MethodEffect> effect_at_step(std::string_view method, const MethodSettings& settings,
                                           const LinearLaw<double>& law, double h, bool with_limit) {
  MethodEffect result;
  result.effective = effective_oscillator_of(method, settings, law, h);
  result.stable = result.effective.stable();
  if (law.stiffness > 0 && (with_limit || !result.stable)) {
    const LinearLaw<double> free{.decay_rate = law.decay_rate, .stiffness = law.stiffness};
    result.stability_limit = first_unstable_step(free, [&](double step) {
      return effective_oscillator_of(method, settings, free, step).spectral_radius;
    });
    // Where every step is stable a radius above 1 is rounding.
    result.stable = result.stable || !result.stability_limit;
  }
  if (std::isnan(result.effective.spectral_radius)) return std::nullopt;
  if (method == "exact") {
    // Also where the step is too long to show the frequency.
    result.effective.angular_frequency = free_frequency(law);
    result.effective.decay_rate =
        result.effective.angular_frequency ? std::optional(law.decay_rate) : std::nullopt;
  }
  return result;
}

std::string in_words(const MethodEffect& effect, const LinearLaw<double>& law) {
  const auto frequency = free_frequency(law);
  const EffectiveOscillator& effective = effect.effective;
  if (!effective.decay_rate || !effective.angular_frequency)
    return without_swing(effect, frequency.has_value());
  if (!frequency)
    return fmt::format("swings at {:.4g} rad/s, where your law creeps back", *effective.angular_frequency);
  if (law.decay_rate > 0 && keeps(*effective.decay_rate, law.decay_rate, *frequency) &&
      keeps(*effective.angular_frequency, *frequency, 0))
    return fmt::format("keeps your damping of {:.4g} 1/s and your {:.6g} rad/s", law.decay_rate, *frequency);
  return damping_in_words(*effective.decay_rate, law.decay_rate, *frequency) + " and " +
         frequency_in_words(*effective.angular_frequency, *frequency);
}

std::string instability_warning(std::string_view method, const MethodEffect& effect, double h,
                                std::string_view motions) {
  if (effect.stable || !effect.stability_limit) return "";
  const std::string what = motions.empty() ? "this law" : fmt::format("{} under this law", motions);
  const char* end = motions.empty() ? "the motion will grow" : "the motion may grow";
  if (*effect.stability_limit == 0)
    return fmt::format("{} is unstable for {} whatever the step: {}", method, what, end);
  return fmt::format("--step: {} s is beyond the stability limit of {} for {}, {:.6g} s: {}", shortest(h),
                     method, what, *effect.stability_limit, end);
}

}  // namespace cromer::core
