// Where the least-squares iteration of a harmonically driven motion begins.
#pragma once

#include <optional>

#include "cromer/identify/motion/motion.h"
#include "cromer/identify/record.h"

namespace cromer::core {

/// The viscous law under a harmonic force: a decaying and a steady sinusoid, their frequencies from the lines
/// of the spectrum, the decay rate from a grid, all else by linear least squares. `drive` [rad/s] if it is
/// known, to within the spectrum's resolution. Empty where the spectrum has no line. `record` has at least 32
/// samples.
std::optional<Motion> driven_start(const Record& record, std::optional<double> drive);

/// The motion whose derivative is a linear motion, from where it rests: `pull` is the drive's acceleration of
/// it at the first time.
Motion integrated(const Motion& derivative, double pull);

}  // namespace cromer::core
