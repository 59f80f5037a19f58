// The JSON object of simulated runs, for documents that hold more.
#pragma once

#include "cromer/study/json/json.h"
#include "cromer/study/task/simulate.h"

namespace cromer {

/// {"runs": [...], "warnings": [...]}, with "message" when a run ended early; `with_states` adds the kept
/// states of each run.
Json simulate_object(const SimulateResult& result, bool with_states);

}  // namespace cromer
