// Where the motion of any law settles under a harmonic drive, by stepping it until it does.
#pragma once

#include "cromer/base/grid.h"
#include "cromer/result.h"
#include "cromer/tasks/simulate/simulate.h"
#include "method_resonance.h"

namespace cromer::core::page {

/// Of the run's method, from rest at each frequency; `options` are those it was set up by. The run's step, or
/// Dormand-Prince to 1e-6 where the options give no tolerance. A point has settled where two windows of ten
/// cycles of the drive give the same amplitude to a thousandth; those that have not after 512 cycles are left
/// out. A curve that would take more than ten million steps is not begun.
Result<MethodResonance> settled_curve(const SimulateOptions& options, const SimulatedRun& run,
                                      const Grid& frequencies);

}  // namespace cromer::core::page
