// The command that simulates a fitted law.
#pragma once

#include <string>

#include "cromer/identify/law_fit.h"
#include "cromer/read/recording.h"

namespace cromer::core {

/// With a mass [kg], by rk4, from the series' first sample to its last, in steps that a sample is a whole
/// number of. Empty where there is none: of a recorded force, whose samples are in a file.
std::string simulate_line(const LawFit& fit, const Series& series, double mass);

}  // namespace cromer::core
