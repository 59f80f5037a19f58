// Ctrl-C and progress: the edges where signals and clocks are.
#pragma once

#include "cromer/base/interrupt.h"

namespace cromer::core::cli {

/// A Watch that Ctrl-C (or a termination signal) interrupts: the first asks the work to stop and keep what it
/// has, the second ends the program. Progress, with the time that is likely left, is shown on standard error
/// after half a second, only on a terminal and unless `quiet`.
Watch watching(bool quiet);

/// The same for work that ranks share: mpirun and srun hand on what the first rank writes, so that there is
/// no terminal to be seen; progress is a line every half minute.
Watch watching_ranks(bool quiet);

/// Takes the progress line away, if there is one.
void clear_progress();

}  // namespace cromer::core::cli
