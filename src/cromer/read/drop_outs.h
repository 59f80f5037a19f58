// Stage 8: stretches of a motion that its sensor did not see.
#pragma once

#include <span>
#include <vector>

#include "cromer/read/recording.h"

namespace cromer::core::dialects {

/// One stretch of samples, from `first` up to, but without, `end`.
struct DropOut {
  std::size_t first, end;
};

/// Two to ten samples, or three and more equal ones, that the motion leaves for by a jump and comes back from
/// by another: both jumps larger than 12 robust standard deviations of the changes near by, on the livelier
/// side. None where the signal mostly stands still (plateaus are no drop-outs), none where they were more
/// than a tenth of the samples. `step` [s] is the median step; a gap in the times is no jump.
std::vector<DropOut> drop_outs(std::span<const double> t, std::span<const double> y, double step,
                               double resolution);

}  // namespace cromer::core::dialects
