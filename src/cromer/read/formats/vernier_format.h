// Vernier Format 2 and 3: Logger Pro's text export. A magic line, a line of source, date and time; then sets
// of a name, long names, short names, units, a blank line and rows, all between tabs.
#pragma once

#include "cromer/read/sets.h"

namespace cromer::core::dialects {

bool is_vernier_format(const Source& source);

/// Each set is a run.
Result<Sets> read_vernier_format(const Source& source);

}  // namespace cromer::core::dialects
