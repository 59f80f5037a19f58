// Samples that a sensor did not measure: flat runs far outside the motion.
#pragma once

#include <cstddef>
#include <vector>

#include "cromer/identify/record.h"

namespace cromer::core {

/// Indices, increasing, of runs of three equal values or more that lie outside the band of the motion (5 % to
/// 95 % of the values, widened by its own width) and are reached and left by a jump that the motion
/// does not make. None where they are more than a tenth of all: that is no drop-out.
std::vector<std::size_t> drop_outs(const Record& record);

}  // namespace cromer::core
