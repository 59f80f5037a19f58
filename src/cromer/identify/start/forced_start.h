// Where the least-squares iteration of a motion under a recorded force begins.
#pragma once

#include <span>

#include "cromer/identify/forced_law.h"
#include "cromer/identify/forced_motion.h"

namespace cromer {

/// Parameters in the order of forced_layout(1, {.curved = curved}), by linear least squares on the equation
/// of motion multiplied with smooth functions that vanish at the ends of stretches of the record, so that no
/// noisy sample is ever differentiated (M. Shinbrot, Trans. ASME 79, 547 (1957)); here windowed sinusoids of
/// all frequencies, weighted as errors of the position (C. Sanathanan & J. Koerner, IEEE Trans. Autom.
/// Control 8, 56 (1963)). `force` has one value for each sample, `spacing` [s] apart; at least 16 of them.
Parameters forced_start(std::span<const double> force, const ForcedSamples& samples, double spacing,
                        bool curved);

}  // namespace cromer
