// A fitted law beside that of a simple pendulum.
#pragma once

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// Whether the length of the simple pendulum with the same frequency of small swings agrees with the radius
/// of the arc that the angle was computed about. Empty where there is none, or the law is linear: only a bent
/// one tells the frequency of small swings from that of those recorded.
Notice arc_beside_pendulum(const FittedRecording& fitted);

/// Where the cubic of a simple pendulum with this frequency of small swings, -w0^2/6, the first term of its
/// sine, lies within the interval of the fitted one. Empty where it does not (of swings so large that further
/// terms count it need not), no angle was fitted, the spring has further odd terms, or no law describes the
/// recording.
Notice cubic_beside_pendulum(const FittedRecording& fitted);

}  // namespace cromer::core
