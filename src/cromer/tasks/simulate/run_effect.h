// What the method of a run really simulates of its law, and what spring and damper transmit.
#pragma once

#include <optional>

#include "cromer/notice.h"
#include "cromer/tasks/methods/method_effect.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// The method's effect on a linear law (spring and damper only), under a harmonic drive with the steady
/// motion. Empty for other laws, and for methods that choose their own steps.
std::optional<MethodEffect> effect_of(const SimulatedRun& run);

/// Says that the step is beyond the method's stability limit, and names the limit: of the linear law, else of
/// small motions about the rest position. Empty if it is not.
Notice step_notice(const SimulatedRun& run);

/// What the method makes of the law. A linear one: "turns your damping of ...". Others, once run, what was
/// measured and where the energy went: "swung at ...; had 0.5 J, of which drag took ...". Empty if neither is
/// known.
Notice effect_notice(const SimulatedRun& run);

/// "settles at 0.38 m, 2.9 rad behind the drive (your law: ...)"; empty if nothing settles.
Notice steady_notice(const SimulatedRun& run);

/// effect_notice and steady_notice after the run's label; empty if both are.
Notice run_notice(const SimulatedRun& run);

/// What a linear law with a spring transmits under a harmonic force, an unbalance or a shaking base; the
/// run's effect must be known. Empty otherwise.
std::optional<RunTransmission> transmission_of(const SimulateOptions& options, const SimulatedRun& run);

}  // namespace cromer::core
