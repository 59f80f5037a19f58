// PASCO Capstone's tables: runs side by side.
#pragma once

#include "cromer/read/header.h"

namespace cromer::core::dialects {

/// Runs may be named in a line of their own above the header, "Run #1,,Run #2,": each name stands above the
/// first column of its run. Taken from the titles and given to the columns, unless these name runs
/// themselves.
void name_runs_above(Header& header);

}  // namespace cromer::core::dialects
