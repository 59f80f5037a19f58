// Which program wrote a file, told from its header, and what Tracker and PASCO Capstone write above it.
#pragma once

#include <string_view>

#include "cromer/read/header.h"

namespace cromer::core::dialects {

/// "PASCO Capstone", "DataStudio", "Tracker", "Logger Pro", "Graphical Analysis", "phyphox", or "plain".
std::string_view dialect_name(const Header& header);

/// Tracker's tables (t, x, y and more without units): several tracks side by side share the time and become
/// runs, called by the names in the line above the header: an empty cell above the time, then each name above
/// the first column of its track.
void name_tracks(Header& header);

/// PASCO Capstone's tables: runs may be named in a line of their own above the header, "Run #1,,Run #2,":
/// each name stands above the first column of its run. Taken from the titles and given to the columns, unless
/// these name runs themselves.
void name_runs_above(Header& header);

}  // namespace cromer::core::dialects
