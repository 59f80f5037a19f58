// What moves beside the axis that is taken.
#pragma once

#include <span>

#include "cromer/read/recording.h"

namespace cromer::core {

/// Whether a gyroscope turns round steadily about an axis while its other two swing alike by an amplitude
/// (rad/s): the axis's mean is far beyond its spread and beyond the amplitude. Else empty.
/// @param during the axis's samples of that time
Notice turns_round(const Series& axis, std::span<const double> during, double amplitude);

/// Of a file without names: another column that swings at the same frequency, and is neither the taken one
/// written again nor its rate of change. The motion may then not lie along the taken one. Else empty.
Notice swings_alongside(const Recording& recording, const Series& taken, int run, const ReadOptions& options);

}  // namespace cromer::core
