// Runs written below each other, told apart by a first column "run": the form of Cromer's own CSV files.
#pragma once

#include "cromer/record/dialects/recording.h"

namespace cromer::dialects {

/// Puts the runs side by side and drops the column of run numbers, if the table is of that form; else does
/// nothing. True if it was. Line numbers are kept in lines_of_run. Where runs share a row of the new table,
/// its line number is that of the longest run.
bool split_stacked_runs(Recording& recording);

}  // namespace cromer::dialects
