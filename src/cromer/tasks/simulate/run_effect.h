// What the method of one run really simulates of its law.
#pragma once

#include <optional>
#include <string>

#include "cromer/tasks/methods/method_effect.h"

namespace cromer::core {

struct SimulatedRun;

/// Of a linear law (spring and damper only) and a method with a step of its own; under a harmonic drive with
/// the steady motion. Empty otherwise.
std::optional<MethodEffect> effect_of(const SimulatedRun& run);

/// Warning of a step beyond the method's stability limit, which it names: of the linear law, else of small
/// motions about the rest position; empty where there is nothing to warn of.
std::string step_warning(const SimulatedRun& run);

/// What the method makes of the law: of a linear one "turns your damping of ..."; of others, once run, what
/// was measured and where the energy went: "swung at ...; had 0.5 J, of which drag took ...". Empty where
/// neither is known.
std::string effect_in_words(const SimulatedRun& run);

/// "settles at 0.38 m, 2.9 rad behind the drive (your law: ...)"; empty where nothing settles.
std::string steady_in_words(const SimulatedRun& run);

/// Both, with the run's label before them; empty where both are.
std::string run_in_words(const SimulatedRun& run);

}  // namespace cromer::core
