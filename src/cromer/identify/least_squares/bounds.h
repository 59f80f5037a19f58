// Coefficients that cannot be negative, and what that does to their intervals.
#pragma once

#include "cromer/identify/free_decay.h"
#include "cromer/identify/free_motion.h"
#include "cromer/identify/least_squares/levenberg_marquardt.h"

namespace cromer {

/// 0 for decay rate, drag and friction, -inf for all else.
Parameters lower_bounds(const FittedParameters& fitted);

/// Moves the 95 % intervals of a fit that was described about its bounded minimum: each is centred on the
/// minimum without bounds, is cut at its bound, and holds the estimate. A warning says which of them touch
/// their bound; where two dampings are traded for each other, what is known of their sum instead.
void set_intervals(FreeDecay& fit, const MotionParameters& free_minimum, const Record& record);

}  // namespace cromer
