// Tracker's data tables (.txt): t, x, y and more without units, one or several tracks.
#pragma once

#include "cromer/read/header.h"

namespace cromer::core::dialects {

bool is_tracker(const Header& header);

/// Several tracks side by side share the time and become runs, called by the names in the line above the
/// header: an empty cell above the time, then each name above the first column of its track.
void name_tracks(Header& header);

}  // namespace cromer::core::dialects
