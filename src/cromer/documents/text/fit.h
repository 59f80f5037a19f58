// Fits as a text for people.
#pragma once

#include <string>
#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// A list of quantities for each recording, each with unit and uncertainty.
std::string fit_text(const std::vector<FittedRecording>& fits);

/// "lab.csv: run 1: too_short: ..." of a fit that did not succeed.
std::string failure_text(const FittedRecording& fitted);

}  // namespace cromer::core
