// What the method of one run really simulates of its law.
#pragma once

#include <optional>
#include <string>

#include "cromer/study/task/method_effect.h"

namespace cromer {

struct SimulatedRun;

/// Of a linear law (no drag, friction or cubic stiffness) and a method with a step of its own; under a
/// harmonic drive with the steady motion. Empty otherwise.
std::optional<MethodEffect> effect_of(const SimulatedRun& run);

/// The run's effect in a sentence: "euler-cromer turns ..."; empty without one.
std::string effect_in_words(const SimulatedRun& run);

}  // namespace cromer
