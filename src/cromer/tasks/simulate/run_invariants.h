// What a run conserves, and how well.
#pragma once

#include <optional>

#include "cromer/analysis/energy.h"
#include "cromer/notice.h"

namespace cromer::core {

struct SimulatedRun;

/// Of a free undamped linear motion by euler-cromer with steps below the stability limit, from the kept
/// states that whole steps reached; empty otherwise, and where nothing moves.
std::optional<ModifiedEnergy> modified_energy_of(const SimulatedRun& run);

/// "euler-cromer conserves ..."; empty where there is none.
Notice modified_energy_notice(const SimulatedRun& run);

}  // namespace cromer::core
