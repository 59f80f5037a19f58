// What a method with a step really simulates, in numbers and in words.
#pragma once

#include <optional>
#include <string_view>

#include "cromer/analysis/effective_oscillator.h"
#include "cromer/methods/method_settings.h"
#include "cromer/model/propagate.h"
#include "cromer/notice.h"

namespace cromer::core {

/// A method's effect on the linear law.
struct MethodEffect {
  EffectiveOscillator effective{};
  bool stable = true;
  std::optional<double> stability_limit{};  // [s] 0 if no step is stable; empty if there is no limit
};

/// The effect of the method of that name (check_method_name) with steps h > 0 [s]. Empty for adaptive
/// methods, which choose their steps, and if an implicit method finds no solution. `exact` keeps the law. The
/// limit is searched for if the step is unstable or `with_limit` asks; a law without a spring has none.
std::optional<MethodEffect> method_effect(std::string_view method, const MethodSettings& settings,
                                          const LinearLaw<double>& law, double h, bool with_limit);

/// The same for every method; for an adaptive one at a step that it might choose.
std::optional<MethodEffect> effect_at_step(std::string_view method, const MethodSettings& settings,
                                           const LinearLaw<double>& law, double h, bool with_limit);

/// The oscillator that the method of that name really simulates with steps h > 0 [s].
EffectiveOscillator effective_oscillator_of(std::string_view method, const MethodSettings& settings,
                                            const LinearLaw<double>& law, double h);

/// What became of decay rate and frequency: "turns your damping of 0.15 1/s into growth of 0.02999 1/s and
/// swings at 5.98 rad/s, 0.3 % too slow".
Notice effect_notice(const MethodEffect& effect, const LinearLaw<double>& law);

/// Says that a step is beyond the stability limit, and names the limit; empty if it is not. If the law is not
/// linear, the effect is that of `motions`, which are named: "small motions".
Notice instability_notice(std::string_view method, const MethodEffect& effect, double h,
                          const Notice& motions = {});

}  // namespace cromer::core
