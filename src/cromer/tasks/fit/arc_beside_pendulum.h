// How long a pendulum is by its frequency, beside how far from the pivot it was seen.
#pragma once

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// Whether the length of the simple pendulum with the same frequency of small swings agrees with the radius
/// of the arc that the angle was computed about. Empty where there is none, or the law is linear: only a bent
/// one tells the frequency of small swings from that of those recorded.
Notice arc_beside_pendulum(const FittedRecording& fitted);

}  // namespace cromer::core
