// What a finished run says about itself: its energy balance, the energy that its method conserves and, where
// no closed form tells, its oscillation.
#pragma once

#include <optional>
#include <vector>

#include "cromer/analysis/energy_balance.h"
#include "cromer/analysis/energy.h"
#include "cromer/analysis/measured_oscillator.h"
#include "cromer/notice.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// From the kept states and the final one; of a run by `exact` from its closed form, with dry friction arc by
/// arc, closed to rounding. Empty if the run ended early, its law has hysteresis, its states are fewer than
/// 20 a period, or the drive jumps or bends between two of them.
std::optional<EnergyBalance> energy_balance_of(const SimulatedRun& run);

/// [J] kinetic and potential, one for each kept state.
std::vector<double> energies(const SimulatedRun& run);

/// Of a free motion under a law that is not linear; empty for others, and with fewer than 8 kept states a
/// period.
std::optional<MeasuredOscillator> measured_oscillator_of(const SimulatedRun& run);

/// Of a free undamped linear motion by euler-cromer with steps below the stability limit, from the kept
/// states that whole steps reached; empty otherwise, and where nothing moves.
std::optional<ModifiedEnergy> modified_energy_of(const SimulatedRun& run);

/// "euler-cromer conserves ..."; empty where there is none.
Notice modified_energy_notice(const SimulatedRun& run);

}  // namespace cromer::core
