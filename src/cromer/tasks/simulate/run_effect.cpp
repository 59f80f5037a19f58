#include "cromer/tasks/simulate/run_effect.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "cromer/base/pi.h"
#include "cromer/methods/all.h"
#include "cromer/model/law_force.h"
#include "cromer/model/linear_quantities.h"
#include "cromer/tasks/simulate/drive_setup.h"
#include "cromer/tasks/simulate/run_energy.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

constexpr double nothing_to_speak_of = 1e-6;  // of the energy that was there

/// "swung at 0.9987 rad/s on average, from 0.934 m down to 0.0893 m".
Notice swing_notice(const MeasuredOscillator& swing) {
  const double change = swing.last_amplitude / swing.first_amplitude - 1;
  if (std::abs(change) < 1e-3)
    return Notice{"swung_evenly",
                  {{"frequency", swing.angular_frequency}, {"amplitude", swing.last_amplitude}}};
  return Notice{change < 0 ? "swung_less_and_less" : "swung_more_and_more",
                {{"frequency", swing.angular_frequency},
                 {"first", swing.first_amplitude},
                 {"last", swing.last_amplitude}}};
}

/// For a law that conserves energy.
Notice kept_energy_notice(const EnergyBalance& balance, bool symplectic) {
  const double off = balance.end / balance.start - 1;
  if (std::abs(off) < nothing_to_speak_of) return Notice{"kept_its_energy", {{"energy", balance.start}}};
  const double percent = 100 * std::abs(off);
  if (symplectic)
    return Notice{off < 0 ? "energy_comes_back" : "energy_goes_again",
                  {{"energy", balance.start}, {"percent", percent}}};
  return Notice{off < 0 ? "method_alone_took" : "method_alone_added",
                {{"energy", balance.start}, {"percent", percent}}};
}

/// Name of a term that gives or takes energy.
template <class T>
Notice name_of_resistance() {
  if constexpr (std::is_same_v<T, Viscous>) return Notice{"damping"};
  if constexpr (std::is_same_v<T, Drag>) return Notice{"drag"};
  if constexpr (std::is_same_v<T, Friction>) return Notice{"friction"};
  return Notice{"term", {{"name", T::coefficients[0].option}}};
}

/// "24 %", "added 24 %", "nothing"; "added about 0.2 %, beside 1.9 % that come and go".
Notice method_notice(const MethodEnergy& method, double there) {
  const double made = method.lasting / there, swing = method.swing / there;
  const bool swings = swing >= std::max(std::abs(made), nothing_to_speak_of);
  const auto percent = [&](const char* took, const char* added) {
    if (std::abs(made) < nothing_to_speak_of) return Notice{"nothing"};
    return Notice{made < 0 ? took : added, {{"percent", 100 * std::abs(made)}}};
  };
  if (!swings) return percent("took_percent", "added_percent");
  return Notice{"and_comes_and_goes",
                {{"lasting", percent("took_about", "added_about")}, {"percent", 100 * swing}}};
}

/// "had 0.5 J, of which drag took 75.6 %, the method itself 24 %".
Notice energy_notice(const EnergyBalance& balance, const MethodEnergy& method, bool symplectic) {
  double there = balance.start;
  Notice givers;
  const auto gain = [&](const Notice& what, double part) {
    if (part <= 0) return;
    there += part;
    givers = givers.empty() ? what : Notice{"and_the", {{"one", givers}, {"other", what}}};
  };
  gain(Notice{"drive"}, balance.drive);
  for_each_resistance([&]<class T>() { gain(name_of_resistance<T>(), -balance.taken_by<T>()); });
  if (!(there > 0)) return {};
  std::vector<Notice> takers;
  const auto add = [&](const Notice& what, double part) {
    if (part > 0)
      takers.push_back(Notice{takers.empty() ? "first_taker" : "next_taker",
                              {{"what", what}, {"percent", 100 * part / there}}});
  };
  for_each_resistance([&]<class T>() { add(name_of_resistance<T>(), balance.taken_by<T>()); });
  if (takers.empty()) return balance.drive == 0 ? kept_energy_notice(balance, symplectic) : Notice{};
  if (!givers.empty()) givers = Notice{"with_what_gave", {{"givers", givers}}};
  // What the method adds may be taken as well.
  const double taken = balance.taken.sum();
  return Notice{
      taken > there ? "energy_turned_over" : "energy_went_to",
      {{"energy", there}, {"givers", givers}, {"takers", takers}, {"method", method_notice(method, there)}}};
}

Notice joined(const Notice& first, const Notice& second) {
  if (first.empty() || second.empty()) return first.empty() ? second : first;
  return Notice{"both", {{"first", first}, {"second", second}}};
}

std::optional<Transmission> simulated_transmission(const RunTransmission& asked, const SimulatedRun& run) {
  if (!run.effect || !run.effect->effective.steady_state) return std::nullopt;
  const EffectiveOscillator& effective = run.effect->effective;
  if (asked.of_motion) return transmitted_motion(asked.sent, *effective.steady_state);
  return transmitted_force(run.oscillator, asked.sent, *effective.steady_state, *effective.steady_velocity);
}

}  // namespace

std::optional<MethodEffect> effect_of(const SimulatedRun& run) {
  const Oscillator<double>& law = run.oscillator;
  if (!is_linear(law_of(law))) return std::nullopt;
  return method_effect(run.method, run.settings, linear_law(run.oscillator, run.drive), run.step, false);
}

Notice step_notice(const SimulatedRun& run) {
  if (run.effect) return instability_notice(run.method, *run.effect, run.step);
  // For a law that is not linear, look at small motions about the rest position, as long as they oscillate;
  // for a spring that hardens, also at its stiffness where the motion begins.
  const Oscillator<double>& o = run.oscillator;
  const double period = natural_period(o);
  if (!(period > 0)) return {};
  const double w = two_pi / period;
  // Drag, friction and the like may outweigh a growth that only vanishes with the step.
  const bool braked = law_of(o).shares(dissipative_terms.without(law_with<Viscous>));
  const auto of_motions = [&](double stiffness, const Notice& motions) -> Notice {
    const LinearLaw<double> tangent{.decay_rate = decay_rate(o), .stiffness = stiffness};
    const auto effect = method_effect(run.method, run.settings, tangent, run.step, false);
    if (!effect || (braked && effect->stability_limit == 0)) return {};
    return instability_notice(run.method, *effect, run.step, motions);
  };
  if (auto small = of_motions(w * w, Notice{"small_motions"}); !small.empty()) return small;
  const double there = stiffness_at(o, run.start.x) / o.mass;
  return there > w * w ? of_motions(there, Notice{"motions_as_at_start"}) : Notice{};
}

Notice effect_notice(const SimulatedRun& run) {
  if (run.effect) return effect_notice(*run.effect, linear_law(run.oscillator, run.drive));
  if (is_linear(law_of(run.oscillator))) return {};
  Notice energy;
  if (run.energy_balance) {
    const MethodEnergy method = method_energy_of(run).value_or(MethodEnergy{run.energy_balance->method(), 0});
    energy = energy_notice(*run.energy_balance, method, find_method(run.method)->symplectic);
  }
  return joined(run.measured ? swing_notice(*run.measured) : Notice{}, energy);
}

Notice steady_notice(const SimulatedRun& run) {
  if (!run.effect || !run.effect->effective.steady_state) return {};
  const SteadyState& steady = *run.effect->effective.steady_state;
  const SteadyState exact = frequency_response(run.oscillator, run.drive.amplitude, run.drive.frequency);
  Notice law;
  if (run.method != "exact" && std::isfinite(exact.amplitude))
    law = Notice{"where_the_law_settles", {{"amplitude", exact.amplitude}, {"lag", exact.phase_lag}}};
  const bool of_base = run.transmission && run.transmission->of_motion;
  return Notice{of_base ? "settles_from_base" : "settles",
                {{"amplitude", steady.amplitude}, {"lag", steady.phase_lag}, {"law", law}}};
}

Notice run_notice(const SimulatedRun& run) {
  const Notice what = joined(effect_notice(run), steady_notice(run));
  return what.empty() ? what : Notice{"of_run", {{"run", run.label}, {"what", what}}};
}

std::optional<RunTransmission> transmission_of(const SimulateOptions& options, const SimulatedRun& run) {
  const Oscillator<double>& law = run.oscillator;
  const bool harmonic = !run.general && run.drive.amplitude > 0 && run.drive.frequency > 0;
  if (!harmonic || !is_linear(law_of(law)) || !(law.stiffness > 0 && law.damping >= 0)) return std::nullopt;
  RunTransmission found;
  found.of_motion = sends_motion(options);
  found.sent = sent_amplitude(options, run);
  found.frequency_ratio = run.drive.frequency / natural_frequency(law);
  found.exact = transmissibility(law, run.drive.frequency);
  found.simulated = simulated_transmission(found, run);
  return found;
}

}  // namespace cromer::core
