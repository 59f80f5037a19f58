// Where the least-squares iteration of a driven motion begins: under a harmonic force (driven_start.cpp) and
// under a recorded one (forced_start.cpp).
#pragma once

#include <optional>

#include "cromer/identify/motion/motion.h"
#include "cromer/identify/record.h"

namespace cromer::core {

/// The viscous law under a harmonic force: a decaying and a steady sinusoid, their frequencies from the lines
/// of the spectrum, the decay rate from a grid, all else by linear least squares. `drive` [rad/s] if it is
/// known, to within the spectrum's resolution or one percent. Empty where the spectrum has no line. `record`
/// has at least 32 samples.
std::optional<Motion> driven_start(const Record& record, std::optional<double> drive);

/// The motion whose derivative is a linear motion, from where it rests: `pull` is the drive's acceleration of
/// it at the first time.
Motion integrated(const Motion& derivative, double pull);

/// The law's linear part (a spring, or none where the law has none) by linear least squares on the equation
/// of motion multiplied with smooth functions that vanish at the ends of stretches of the record, so that no
/// noisy sample is ever differentiated (M. Shinbrot, Trans. ASME 79, 547 (1957)); here windowed sinusoids of
/// all frequencies, weighted as errors of the position (C. Sanathanan & J. Koerner, IEEE Trans. Autom.
/// Control 8, 56 (1963)). A quadratic and a cubic spring stand in the equation for whatever bends it, or an
/// odd-quadratic and a quintic one where the law has both; a law that has them gets them. Where the
/// force explains no spring its frequency is that of the record's strongest line. Empty where the spring
/// found does not hold the body where it rests. At least 16 samples.
std::optional<Motion> forced_start(const Record& record, const ForceRecord& force, const Law& law);

}  // namespace cromer::core
