// Runs written below each other: told apart by a first column "run", the form of Cromer's own CSV files, or
// by a time that starts again.
#pragma once

#include "cromer/read/recording.h"

namespace cromer::core::dialects {

/// Puts the runs side by side and drops the column of run numbers, if the table is of that form; else does
/// nothing. True if it was.
bool split_stacked_runs(Recording& recording);

/// Puts the runs side by side where the one time column starts again, and says so.
void split_at_restarts(Recording& recording);

}  // namespace cromer::core::dialects
