// From the options of `simulate` to the runs they ask for: checks, then defaults.
#pragma once

#include <vector>

#include "cromer/base/result.h"
#include "cromer/study/task/simulate.h"

namespace cromer {

/// The runs to do, method outermost, with law, drive, start, step and end; nothing is integrated yet. An
/// Error names option, value and constraint.
Result<std::vector<SimulatedRun>> set_up_runs(const SimulateOptions& options);

/// What the options say that has no effect or is not exact.
std::vector<std::string> setup_warnings(const SimulateOptions& options,
                                        const std::vector<SimulatedRun>& runs);

/// Period of small oscillations [s] about the rest position: x = 0, or the bottom of a double well. 0 where
/// there is none.
double natural_period(const Oscillator<double>& oscillator);

}  // namespace cromer
