// Fits as a text for people.
#pragma once

#include <string>
#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// A list of quantities for each recording, each with unit and uncertainty.
std::string fit_text(const std::vector<FittedRecording>& fits);

}  // namespace cromer::core
