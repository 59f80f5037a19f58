// Tasks of a study about networks of masses.
#pragma once

#include "cromer/study/work.h"

namespace cromer::core {

/// `simulate` with `network`: runs of a network, whose file says what moves.
Result<TaskReport> simulate_network_task(const Work& work);

/// `fit` with `network`: the open values of a network, from a recording.
Result<TaskReport> fit_network_task(const Work& work);

/// `modes` of a network, or of a recording, which may be set beside a network.
Result<TaskReport> modes_task(const Work& work);

}  // namespace cromer::core
