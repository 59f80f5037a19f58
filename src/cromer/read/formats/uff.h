// Universal files (UFF), dataset 58: functions at nodal degrees of freedom, as text and as binary (58b).
// Source: SDRC, University of Cincinnati, "Universal File Datasets", dataset 58.
#pragma once

#include <string_view>

#include "cromer/read/set.h"
#include "cromer/result.h"

namespace cromer::core::dialects {

/// Begins with the line "    -1", blank lines and line ends before it allowed, and a dataset's number.
bool is_uff(std::string_view bytes);

/// Every time response is a column with its times; those at the same times share them. Other datasets, other
/// functions (spectra, frequency responses) and complex values are left out and said. The bytes are the
/// file's, since binary values stand between the lines.
Result<Sets> read_uff(std::string_view bytes);

}  // namespace cromer::core::dialects
