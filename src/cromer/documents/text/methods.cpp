#include "cromer/documents/text.h"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "cromer/base/pi.h"
#include "cromer/documents/text/words.h"
#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace {

std::string table(std::span<const MethodRow> methods) {
  const auto yes = [](bool is) { return std::string(is ? "yes" : "-"); };
  std::vector<std::vector<std::string>> rows{
      {"method", "order", "implicit", "symplectic", "reversible", "A-stable", "adaptive", "source"}};
  for (const auto& method : methods)
    rows.push_back({std::string(method.name), method.order_text, yes(method.implicit), yes(method.symplectic),
                    yes(method.reversible), yes(method.a_stable), yes(method.adaptive),
                    std::string(method.source)});
  return text_table(rows, 1, 2) +
         "\nimplicit: a step solves an equation; symplectic (without damping): energy is kept for good, "
         "within bounds;\nreversible: a step back undoes a step; A-stable: stable at any step where the law "
         "is; adaptive: chooses its own steps.\n" +
         in_words(Notice{"methods_with_step"}) + ".\n";
}

std::string number_or(const std::optional<double>& value, const char* otherwise = "") {
  return value ? fmt::format("{:.6g}", *value) : otherwise;
}

/// How far a number is off what was asked for; empty where one of them is not there.
std::string off_by(const std::optional<double>& value, const std::optional<double>& asked) {
  if (!value || !asked || *asked == 0) return "";
  return percent_off(*value / *asked - 1);
}

/// The law asked for, as the method that is exact has it.
std::string asked_for(const MethodsOptions& options, const EffectiveOscillator& law) {
  const double w = *options.natural_frequency, h = *options.step;
  const std::string steps = fmt::format("step {:.6g} s: w0 h = {:.4g}", h, w * h);
  const std::string damping = fmt::format("decay rate {:.6g} 1/s", options.damping_ratio.value_or(0) * w);
  if (!law.angular_frequency)
    return fmt::format("asked for: {}, {:.6g} rad/s: too damped to swing; {}\n\n", damping, w, steps);
  return fmt::format(
      "asked for: {}, frequency {:.6g} rad/s, energy x {:.6g} a cycle; {}, {:.3g} steps a cycle\n\n", damping,
      *law.angular_frequency, *law.energy_factor(), steps, two_pi / (*law.angular_frequency * h));
}

std::string effects_table(const MethodsOptions& options, std::span<const MethodRow> methods) {
  EffectiveOscillator law;
  for (const auto& method : methods)
    if (method.name == "exact" && method.effect) law = method.effect->effective;
  std::vector<std::vector<std::string>> rows{{"method", "decay rate (1/s)", "off by", "frequency (rad/s)",
                                              "off by", "energy/cycle", "stable up to (s)", "stable"}};
  std::string words;
  for (const auto& method : methods) {
    const std::string name(method.name);
    if (!method.effect) {
      words += name + (method.adaptive ? " chooses its own steps\n" : " finds no solution of its equation\n");
      continue;
    }
    const EffectiveOscillator& effective = method.effect->effective;
    rows.push_back({name, number_or(effective.decay_rate), off_by(effective.decay_rate, law.decay_rate),
                    number_or(effective.angular_frequency),
                    off_by(effective.angular_frequency, law.angular_frequency),
                    number_or(effective.energy_factor()), number_or(method.effect->stability_limit, "any"),
                    method.effect->stable ? "yes" : "no"});
    words += name + " " + in_words(method.words) + "\n";
  }
  return asked_for(options, law) + text_table(rows, 1, 7) + "\nWith this step\n" + words;
}

}  // namespace

std::string methods_text(const MethodsOptions& options, std::span<const MethodRow> methods) {
  return options.step ? effects_table(options, methods) : table(methods);
}

}  // namespace cromer::core
