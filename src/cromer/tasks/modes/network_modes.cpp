#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "cromer/analysis/complex_modes.h"
#include "cromer/base/disjoint_sets.h"
#include "cromer/base/pi.h"
#include "cromer/methods/all.h"
#include "cromer/methods/vector_newton.h"
#include "cromer/model/network_system.h"
#include "cromer/tasks/methods/unused_by_method.h"
#include "cromer/tasks/modes/modes_options.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// A number that is known.
Estimate exactly(double value) { return {value, 0, value, value}; }

/// The network with the slopes of its forces at rest in their place, and nothing that drives it.
Network small_motions(const Network& network) {
  Network linear = network;
  for (NetworkMass& mass : linear.masses) mass.drive = {};
  for (NetworkLink& link : linear.links) {
    const State<double> slopes = slopes_at_rest(link.law);
    link.law = {.stiffness = slopes.x, .damping = slopes.v};
  }
  return linear;
}

/// One step h of the method from (x, h v, h^2 a).
template <class M>
EffectiveNetwork effective_network_of(const M& method, const Network& network,
                                      const std::vector<ComplexMode>& modes, double h) {
  const NetworkSystem<> system(small_motions(network));
  const std::size_t n = network.masses.size();
  constexpr bool carries = CarriesAcceleration<M, typename M::template Memory<MassVector>>;
  return effective_network(modes, carries ? 3 : 2, h, [&](const std::vector<double>& from) {
    Vector x = Vector::of_size(n), v = x;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] = from[i];
      v[i] = from[n + i] / h;
    }
    const State<MassVector> y{{x, 0}, {v, 0}};
    auto memory = method.start(system, 0.0, y);
    if constexpr (carries)
      for (std::size_t i = 0; i < n; ++i) method.carried(memory).first[i] = from[2 * n + i] / (h * h);
    const Trial<MassVector> trial = method.step(system, 0.0, h, y, memory);
    std::vector<double> to(from.size(), no_number);
    if (!trial.converged) return to;
    for (std::size_t i = 0; i < n; ++i) {
      to[i] = trial.y.x.first[i];
      to[n + i] = h * trial.y.v.first[i];
      if constexpr (carries) to[2 * n + i] = h * h * method.carried(memory).first[i];
    }
    return to;
  });
}

/// The closed form keeps every mode, in steps of h [s].
std::vector<EffectiveOscillator> as_they_are(const std::vector<ComplexMode>& modes, double h) {
  std::vector<EffectiveOscillator> kept;
  for (const ComplexMode& mode : modes) {
    EffectiveOscillator& effective = kept.emplace_back();
    for (const std::complex<double>& z : {mode.first, mode.second}) {
      const std::complex<double> of_step = std::exp(z * h);
      effective.eigenvalues.push_back({of_step.real(), of_step.imag()});
      effective.spectral_radius = std::max(effective.spectral_radius, std::abs(of_step));
    }
    if (mode.first.imag() <= 0) continue;
    effective.decay_rate = -mode.first.real();
    effective.angular_frequency = mode.first.imag();
  }
  return kept;
}

/// What a method with a step makes of all modes.
struct MethodOnModes {
  std::vector<MethodEffect> effects;
  bool stable = true;
  bool solved = true;  ///< its steps' equations have a solution
};

/// Modes that damping does not couple are oscillators by themselves.
MethodOnModes on_uncoupled_modes(const std::string& name, const MethodSettings& settings,
                                 const std::vector<ComplexMode>& modes, double h) {
  MethodOnModes result;
  for (const ComplexMode& mode : modes) {
    const auto effect = method_effect(name, settings, mode.law(), h, false);
    if (!effect) result.solved = false;
    result.effects.push_back(effect.value_or(MethodEffect{}));
    result.stable = result.stable && result.effects.back().stable;
  }
  return result;
}

/// Modes that damping couples take their steps together.
MethodOnModes on_coupled_modes(const std::string& name, const MethodSettings& settings,
                               const Network& network, const std::vector<ComplexMode>& modes, double h) {
  const bool exact = find_method(name)->is_exact();
  EffectiveNetwork effective;
  if (exact)
    effective.modes = as_they_are(modes, h);
  else
    effective = visit_method(name, settings, [&](const auto& method) {
      using M = std::decay_t<decltype(method)>;
      if constexpr (M::info.takes_fixed_steps())
        return effective_network_of(method, network, modes, h);
      else
        return EffectiveNetwork{};
    });
  MethodOnModes result;
  result.solved = !std::isnan(effective.spectral_radius);
  for (EffectiveOscillator& each : effective.modes) {
    MethodEffect& effect = result.effects.emplace_back();
    effect.stable = each.stable();
    effect.effective = std::move(each);
  }
  result.stable = exact || effective.spectral_radius <= 1 + 1e-12;
  return result;
}

void add_method(std::vector<NaturalMode>& into, const std::string& name, const ModesOptions& options,
                const Network& network, const std::vector<ComplexMode>& modes, bool uncoupled,
                std::vector<Notice>& notices) {
  const MethodSettings settings = method_settings_of(options);
  const double h = *options.step;
  const MethodOnModes made = uncoupled ? on_uncoupled_modes(name, settings, modes, h)
                                       : on_coupled_modes(name, settings, network, modes, h);
  if (!made.solved) {
    notices.push_back(Notice{"method_finds_no_solution", {{"method", name}, {"step", h}}});
    return;
  }
  // A network that grows by itself is to grow at any step.
  const bool grows = std::any_of(modes.begin(), modes.end(), [](const ComplexMode& mode) {
    return mode.law().decay_rate < 0 || mode.law().stiffness < 0;
  });
  if (!made.stable && !grows)
    notices.push_back(Notice{"method_unstable_on_network", {{"method", name}, {"step", h}}});
  for (std::size_t j = 0; j < modes.size(); ++j) {
    const MethodEffect& effect = made.effects[j];
    Notice words = effect_notice(effect, modes[j].law());
    // Only what is pulled back can creep back.
    if (words.code == "creeps_as_the_law" && !(modes[j].law().stiffness > 0))
      words = Notice{"does_not_swing_as_the_law"};
    into[j].methods.push_back({name, h, effect, std::move(words)});
  }
}

/// What the modes of small motions leave out: terms that are not linear, and dry friction.
std::vector<Notice> notices_on(const Network& network) {
  std::vector<Notice> notices;
  const Law law = law_of(network).without(linear_terms);
  if (law.size() == 0) return notices;
  std::vector<std::string> terms;
  for (std::size_t i = 0; i < term_count; ++i)
    if (law.has(i) && term_infos[i].name != Friction::info.name) terms.emplace_back(term_infos[i].name);
  if (!terms.empty()) notices.push_back(Notice{"modes_of_small_motions", {{"terms", terms}}});
  if (law.has<Friction>()) notices.push_back(Notice{"modes_without_friction"});
  return notices;
}

/// How many bodies can move without stretching a spring: groups of masses that springs hold together, but not
/// to the ground.
int free_bodies(const Network& network) {
  const std::size_t count = network.masses.size();
  DisjointSets held(count + 1);  // the last one is the ground
  for (const NetworkLink& link : network.links)
    if (slopes_at_rest(link.law).x != 0) held.join(std::min(link.from, count), std::min(link.to, count));
  int bodies = -1;  // the ground is none
  for (std::size_t i = 0; i <= count; ++i) bodies += held.leader(i) == i;
  return bodies;
}

}  // namespace

Result<ModesResult> network_modes(const Network& network, const std::string& file,
                                  const ModesOptions& options) {
  if (const std::string_view name = option_of_recordings(options); !name.empty())
    return Error{"option_of_recordings", {{"option", name}, {"file", file}}};
  if (auto good = check_modes_options(options); !good) return good.error();
  if (network.masses.size() > most_masses_for_modes)
    return Error{"too_many_masses_for_modes",
                 {{"file", file}, {"masses", network.masses.size()}, {"most", most_masses_for_modes}}};
  const LinearNetwork linear = linearised(network);
  const std::vector<ComplexMode> modes = complex_modes(linear);
  const bool uncoupled = !modal_damping(linear, undamped_modes(linear)).empty();

  ModesResult result{.file = file, .notices = notices_on(network), .network = network};
  for (const NetworkMass& mass : network.masses) result.names.push_back(mass.name);
  int free = 0, falling = 0;
  for (const ComplexMode& mode : modes) {
    const LinearLaw<double> law = mode.law();
    const double w = law.stiffness >= 0 ? std::sqrt(std::abs(law.stiffness)) : no_number;  // 0, not -0
    free += law.stiffness == 0;
    falling += law.stiffness < 0;
    result.modes.push_back({.frequency = exactly(w / two_pi),
                            .damping_ratio = exactly(w > 0 ? law.decay_rate / w : no_number),
                            .shape = mode.shape,
                            .participation = participation(linear, mode)});
  }
  const int bodies = std::min(free, free_bodies(network));
  if (bodies > 0) result.notices.push_back(Notice{"modes_of_free_bodies", {{"modes", bodies}}});
  if (free > bodies) result.notices.push_back(Notice{"slow_modes_lost", {{"modes", free - bodies}}});
  if (falling > 0) result.notices.push_back(Notice{"modes_that_fall_away", {{"modes", falling}}});
  for (const std::string& method : options.method) say_unused_by_method(method, options, result.notices);
  for (const std::string& method : options.method)
    add_method(result.modes, method, options, network, modes, uncoupled, result.notices);
  return result;
}

}  // namespace cromer::core
