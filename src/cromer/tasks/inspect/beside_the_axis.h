// What moves beside the axis that is taken.
#pragma once

#include <span>

#include "cromer/read/recording.h"
#include "cromer/tasks/inspect/axis_swing.h"

namespace cromer::core {

/// Whether a gyroscope turns round steadily about an axis while its other two swing alike, as often as it
/// turns: the axis's mean [rad/s] is far beyond its spread, beyond their amplitude, and within a fifth of
/// their angular frequency. Else empty. `during`: the axis's samples of that time, not empty.
Notice turns_round(const Series& axis, std::span<const double> during, const AxisSwing& swing);

/// Of a file without names: another column that swings at the same frequency, and is neither the taken one
/// written again nor its rate of change. The motion may then not lie along the taken one. Else empty.
Notice swings_alongside(const Recording& recording, const Series& taken, int run, const ReadOptions& options);

}  // namespace cromer::core
