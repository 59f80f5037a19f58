// Where the least-squares iteration of a harmonically driven motion begins.
#pragma once

#include <optional>

#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/identify/record.h"

namespace cromer {

/// Parameters of the viscous law under a SinusoidalForce in the order of forced_layout: a decaying and a
/// steady sinusoid, their frequencies from the lines of the spectrum, the decay rate from a grid, all else by
/// linear least squares. `drive` [rad/s] if it is known, to within the spectrum's resolution. Empty where the
/// spectrum has no line. `record` has values from a fixed level, at least 32; of velocities or accelerations
/// the parameters are those of the displacement.
std::optional<Parameters> driven_start(const Record& record, std::optional<double> drive);

}  // namespace cromer
