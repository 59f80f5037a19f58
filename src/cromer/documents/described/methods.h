// What the document of `methods` consists of.
#pragma once

#include "cromer/documents/described/describe.h"
#include "cromer/tasks/methods/methods.h"

namespace cromer::core {

template <>
struct Described<SteadyState> {
  static constexpr std::string_view name = "SteadyState";
  static constexpr auto entries =
      members(field("amplitude", &SteadyState::amplitude, "m",
                    "amplitude of the steady motion as the method simulates it"),
              field("phase", &SteadyState::phase_lag, "rad", "its lag behind the force"));
};

template <>
struct Described<EffectiveOscillator> {
  using Effective = EffectiveOscillator;
  static constexpr std::string_view name = "Effective";
  static constexpr auto entries =
      members(field("decay_rate", &Effective::decay_rate, "1/s",
                    "decay rate of the simulated motion; null if nothing oscillates"),
              field("angular_frequency", &Effective::angular_frequency, "rad/s",
                    "angular frequency of the simulated motion; null if nothing oscillates"),
              field("spectral_radius", &Effective::spectral_radius, "", "largest modulus of the eigenvalues"),
              field(
                  "eigenvalues",
                  [](const Effective& found) {
                    std::vector<Pair> pairs;
                    for (const auto& z : found.eigenvalues) pairs.push_back({z.re, z.im});
                    return pairs;
                  },
                  "", "eigenvalues of one step, real and imaginary parts; the physical pair first")
                  .known(),
              field("steady_state", &Effective::steady_state, "",
                    "steady motion; only of a driven motion that settles")
                  .left_out());
};

/// Values of a method's effect; empty where there is no effect.
inline std::optional<bool> stable_of(const std::optional<MethodEffect>& effect) {
  return effect ? std::optional(effect->stable) : std::nullopt;
}
/// A number that may be left out (the outer optional is empty) or null (the inner one is).
using NumberIfAny = std::optional<std::optional<double>>;
inline NumberIfAny stability_limit_of(const std::optional<MethodEffect>& effect) {
  return effect ? NumberIfAny(std::in_place, effect->stability_limit) : NumberIfAny();
}
inline NumberIfAny energy_factor_of(const std::optional<MethodEffect>& effect) {
  return effect ? NumberIfAny(std::in_place, effect->effective.energy_factor()) : NumberIfAny();
}
inline std::optional<EffectiveOscillator> effective_of(const std::optional<MethodEffect>& effect) {
  return effect ? std::optional(effect->effective) : std::nullopt;
}

/// "stable" and "energy_factor_per_cycle"; `effect` finds the effect in the result.
template <class Effect>
constexpr auto stable_entry(Effect effect) {
  return field(
             "stable", [effect](const auto& r) { return stable_of(std::invoke(effect, r)); }, "",
             "whether the simulated motion stays bounded")
      .left_out();
}
template <class Effect>
constexpr auto energy_factor_entry(Effect effect) {
  return field(
             "energy_factor_per_cycle",
             [effect](const auto& r) { return energy_factor_of(std::invoke(effect, r)); }, "",
             "factor of the energy over a cycle of the simulated motion; null if nothing oscillates")
      .left_out();
}

/// What the method of a run really simulates.
template <class Effect>
constexpr auto effect_entries(Effect effect) {
  return members(field(
                     "effective", [effect](const auto& r) { return effective_of(std::invoke(effect, r)); },
                     "", "what the method really simulates; null if the law is not linear"),
                 stable_entry(effect),
                 field(
                     "stability_limit",
                     [effect](const auto& r) {
                       const std::optional<MethodEffect>& found = std::invoke(effect, r);
                       return found && found->stable ? NumberIfAny() : stability_limit_of(found);
                     },
                     "s", "longest stable step, only if this one is longer; null if there is none")
                     .left_out(),
                 energy_factor_entry(effect));
}

template <>
struct Described<MethodRow> {
  static constexpr std::string_view name = "Method";
  static constexpr auto entries = members(
      field("name", &MethodRow::name, "", "name, as typed"),
      field("order", &MethodRow::order, "", "order; null for exact"),
      field("implicit", &MethodRow::implicit, "", "whether each step solves an equation"),
      field("symplectic", &MethodRow::symplectic, "", "whether it is symplectic for the undamped law"),
      field("adaptive", &MethodRow::adaptive, "", "whether it chooses its own steps"),
      field("reversible", &MethodRow::reversible, "", "whether a step back undoes a step"),
      field("a_stable", &MethodRow::a_stable, "", "whether it is stable at any step if the law is"),
      field("source", &MethodRow::source, "", "publication"),
      field(
          "effective", [](const MethodRow& row) { return effective_of(row.effect); }, "",
          "what it really simulates; only if a step was given")
          .left_out(),
      stable_entry(&MethodRow::effect),
      field(
          "stability_limit", [](const MethodRow& row) { return stability_limit_of(row.effect); }, "s",
          "longest stable step; null if there is no limit, 0 if no step is stable")
          .left_out(),
      energy_factor_entry(&MethodRow::effect),
      field(
          "in_words",
          [](const MethodRow& row) { return row.effect ? std::optional(row.words) : std::nullopt; }, "",
          "the same in words")
          .left_out());
};

}  // namespace cromer::core
