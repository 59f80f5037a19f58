// What the method of one run really simulates of its law, and what gets through spring and damper.
#pragma once

#include <optional>
#include <string_view>

#include "cromer/notice.h"
#include "cromer/tasks/methods/method_effect.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// Of a linear law (spring and damper only) and a method with a step of its own; under a harmonic drive with
/// the steady motion. Empty otherwise.
std::optional<MethodEffect> effect_of(const SimulatedRun& run);

/// Says that the step is beyond the method's stability limit, which it names: of the linear law, else of
/// small motions about the rest position; empty where it is not.
Notice step_notice(const SimulatedRun& run);

/// What the method makes of the law: of a linear one "turns your damping of ..."; of others, once run, what
/// was measured and where the energy went: "swung at ...; had 0.5 J, of which drag took ...". Empty where
/// neither is known.
Notice effect_notice(const SimulatedRun& run);

/// "settles at 0.38 m, 2.9 rad behind the drive (your law: ...)"; empty where nothing settles.
Notice steady_notice(const SimulatedRun& run);

/// Both, with the run's label before them; empty where both are.
Notice run_notice(const SimulatedRun& run);

/// Of a linear law with a spring under a harmonic force, an unbalance or a shaking base; the run's effect
/// must be known. Empty otherwise.
std::optional<RunTransmission> transmission_of(const SimulateOptions& options, const SimulatedRun& run);

/// "transmissibility: displacement of the mass over that of the base".
std::string_view transmission_title(const RunTransmission& transmission);

}  // namespace cromer::core
