// A method's effect as the contract's "effective" object and what goes with it.
#pragma once

#include <optional>

#include "cromer/documents/json/json.h"
#include "cromer/tasks/methods/method_effect.h"

namespace cromer::core {

inline Json json_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

inline Json to_json(const EffectiveOscillator& effective) {
  Json eigenvalues = Json::array();
  for (const auto& z : effective.eigenvalues) eigenvalues.push_back({z.re, z.im});
  Json object{{"decay_rate", json_or_null(effective.decay_rate)},
              {"angular_frequency", json_or_null(effective.angular_frequency)},
              {"spectral_radius", effective.spectral_radius},
              {"eigenvalues", std::move(eigenvalues)}};
  if (effective.steady_state)
    object["steady_state"] = {{"amplitude", effective.steady_state->amplitude},
                              {"phase", effective.steady_state->phase_lag}};
  return object;
}

/// "effective", null where none is known, with "stable", "energy_factor_per_cycle" and, where it is passed,
/// "stability_limit".
inline void add_effect(Json& object, const std::optional<MethodEffect>& effect) {
  object["effective"] = effect ? to_json(effect->effective) : Json(nullptr);
  if (!effect) return;
  object["stable"] = effect->stable;
  if (!effect->stable) object["stability_limit"] = json_or_null(effect->stability_limit);
  object["energy_factor_per_cycle"] = json_or_null(effect->effective.energy_factor());
}

}  // namespace cromer::core
