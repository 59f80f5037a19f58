#include "cromer/tasks/simulate/run_effect.h"

#include <fmt/format.h>
#include "cromer/model/linear_quantities.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cromer/methods/all.h"
#include "cromer/model/terms.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

constexpr double nothing_to_speak_of = 1e-6;  // of the energy that was there

/// "swung at 0.9987 rad/s on average, from 0.934 m down to 0.0893 m".
std::string swing_in_words(const MeasuredOscillator& swing) {
  const double change = swing.last_amplitude / swing.first_amplitude - 1;
  const std::string words = fmt::format("swung at {:.6g} rad/s on average, ", swing.angular_frequency);
  if (std::abs(change) < 1e-3) return words + fmt::format("{:.4g} m to each side", swing.last_amplitude);
  return words + fmt::format("from {:.4g} m {} to {:.4g} m", swing.first_amplitude,
                             change < 0 ? "down" : "up", swing.last_amplitude);
}

/// Of a law that keeps its energy.
std::string kept_energy_in_words(const EnergyBalance& balance, bool symplectic) {
  const double off = balance.end / balance.start - 1;
  if (std::abs(off) < nothing_to_speak_of) return fmt::format("kept its {:.4g} J", balance.start);
  const std::string percent = fmt::format("{:.2g} %", 100 * std::abs(off));
  if (symplectic)
    return fmt::format("had {:.4g} J and at the end {} {}, which comes and goes", balance.start, percent,
                       off < 0 ? "less" : "more");
  return fmt::format("had {:.4g} J, {} the method itself {} {}", balance.start,
                     off < 0 ? "of which" : "to which", off < 0 ? "took" : "added", percent);
}

/// "had 0.5 J, of which drag took 75.6 %, the method itself 24 %".
std::string energy_in_words(const EnergyBalance& balance, bool symplectic) {
  double there = balance.start;
  std::string givers, takers;
  const auto gain = [&](std::string_view what, double part) {
    if (part <= 0) return;
    there += part;
    givers += fmt::format("{}{}", givers.empty() ? " with what the " : " and the ", what);
  };
  gain("drive", balance.drive);
  for_each_resistance([&]<class T>() { gain(T::coefficients[0].option, -balance.taken_by<T>()); });
  if (!(there > 0)) return "";
  const auto add = [&](std::string_view what, double part) {
    if (part > 0)
      takers +=
          fmt::format("{}{} {:.3g} %", takers.empty() ? "" : ", ",
                      takers.empty() ? std::string(what) + " took" : std::string(what), 100 * part / there);
  };
  for_each_resistance([&]<class T>() { add(T::coefficients[0].option, balance.taken_by<T>()); });
  if (takers.empty()) return balance.drive == 0 ? kept_energy_in_words(balance, symplectic) : "";
  const double made = balance.method() / there;
  const std::string method = std::abs(made) < nothing_to_speak_of ? "nothing"
                             : made < 0                           ? fmt::format("{:.2g} %", -100 * made)
                                                                  : fmt::format("added {:.2g} %", 100 * made);
  return fmt::format("had {:.4g} J{}, of which {}, the method itself {}", there,
                     givers.empty() ? "" : givers + " gave", takers, method);
}

std::string joined(const std::string& first, const std::string& second) {
  return first.empty() || second.empty() ? first + second : first + "; " + second;
}

}  // namespace

std::optional<MethodEffect> effect_of(const SimulatedRun& run) {
  const Oscillator<double>& law = run.oscillator;
  if (!is_linear(law_of(law))) return std::nullopt;
  return method_effect(run.method, run.settings, linear_law(run.oscillator, run.drive), run.step, false);
}

std::string step_warning(const SimulatedRun& run) {
  if (run.effect) return instability_warning(run.method, *run.effect, run.step, "");
  // Of a law that is not linear the small motions about the rest position tell, as long as they swing; of a
  // spring that hardens also its stiffness where the motion begins.
  const Oscillator<double>& o = run.oscillator;
  const double period = natural_period(o);
  if (!(period > 0)) return "";
  const double w = 2 * std::numbers::pi / period;
  // What drag, friction and their like take may outweigh a growth that only vanishes with the step.
  const bool braked = law_of(o).shares(dissipative_terms.without(law_with<Viscous>));
  const auto warning = [&](double stiffness, std::string_view motions) -> std::string {
    const LinearLaw<double> tangent{.decay_rate = decay_rate(o), .stiffness = stiffness};
    const auto effect = method_effect(run.method, run.settings, tangent, run.step, false);
    if (!effect || (braked && effect->stability_limit == 0)) return "";
    return instability_warning(run.method, *effect, run.step, motions);
  };
  if (auto small = warning(w * w, "small motions"); !small.empty()) return small;
  const double there = stiffness_at(o, run.start.x) / o.mass;
  return there > w * w ? warning(there, "motions as wide as at the start") : "";
}

std::string effect_in_words(const SimulatedRun& run) {
  if (run.effect) return in_words(*run.effect, linear_law(run.oscillator, run.drive));
  if (is_linear(law_of(run.oscillator))) return "";
  return joined(
      run.measured ? swing_in_words(*run.measured) : "",
      run.energy_balance ? energy_in_words(*run.energy_balance, find_method(run.method)->symplectic) : "");
}

std::string steady_in_words(const SimulatedRun& run) {
  if (!run.effect || !run.effect->effective.steady_state) return "";
  const SteadyState& steady = *run.effect->effective.steady_state;
  const SteadyState exact = frequency_response(run.oscillator, run.drive.amplitude, run.drive.frequency);
  std::string words =
      fmt::format("settles at {:.6g} m{}, {:.4g} rad behind the drive", steady.amplitude,
                  run.transmission && run.transmission->of_motion ? " from the base" : "", steady.phase_lag);
  if (run.method != "exact" && std::isfinite(exact.amplitude))
    words += fmt::format(" (your law: {:.6g} m, {:.4g} rad)", exact.amplitude, exact.phase_lag);
  return words;
}

std::string run_in_words(const SimulatedRun& run) {
  const std::string words = joined(effect_in_words(run), steady_in_words(run));
  return words.empty() ? "" : run.label + " " + words;
}

}  // namespace cromer::core
