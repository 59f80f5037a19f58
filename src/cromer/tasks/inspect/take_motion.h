// The column of a recording that holds its motion.
#pragma once

#include <string_view>

#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core {

/// take_series(), which see. Where no column is named and the axes of a sensor are alike, as in the files of
/// a phone, the one that swings most clearly is taken; of x and y that lie on an arc, as of a pendulum on
/// film, the angle about its centre. A notice says so.
Result<Series> take_motion(const Recording& recording, std::string_view column, int run,
                           const ReadOptions& options);

}  // namespace cromer::core
