// What a finished run shows: its energy balance, the energy that its method conserves, and the oscillation of
// a law without a closed form.
#pragma once

#include <optional>
#include <vector>

#include "cromer/analysis/energy.h"
#include "cromer/analysis/energy_balance.h"
#include "cromer/analysis/measured_oscillator.h"
#include "cromer/notice.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// From the kept states and the final one. A run by `exact` uses its closed form (with dry friction arc by
/// arc), and closes to rounding. Empty if the run ended early, its law has hysteresis, a period has fewer
/// than 20 states, or the drive jumps or bends between two of them.
std::optional<EnergyBalance> energy_balance_of(const SimulatedRun& run);

/// What the method made (+) or lost (-) by the end of a free motion under a law that is not linear. Some of
/// it comes and goes with each half cycle.
struct MethodEnergy {
  double lasting = 0;  // [J] on average over the last half cycle, from its ends and its middle
  double swing = 0;    // [J] >= 0 to each side of the average: of the last half cycle, or of a symplectic
                       // method the larger of the first and the last
};

/// From run.measured and run.energy_balance; empty without either.
std::optional<MethodEnergy> method_energy_of(const SimulatedRun& run);

/// Kinetic plus potential energy of each kept state [J].
std::vector<double> energies(const SimulatedRun& run);

/// The oscillation of a free motion under a law that is not linear. Empty for others, and if a period has
/// fewer than 8 kept states.
std::optional<MeasuredOscillator> measured_oscillator_of(const SimulatedRun& run);

/// The energy that euler-cromer conserves in a free undamped linear motion below its stability limit, from
/// the kept states that whole steps reached. Empty otherwise, and if nothing moves.
std::optional<ModifiedEnergy> modified_energy_of(const SimulatedRun& run);

/// "euler-cromer conserves ..."; empty if there is none.
Notice modified_energy_notice(const SimulatedRun& run);

}  // namespace cromer::core
