// The options of a fit under a recorded force. The page leaves it out.
#pragma once

#include "cromer/result.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// Checks that each is given where it has a meaning, with a value that it can have.
Result<void> check_force_options(const FitOptions& options);

}  // namespace cromer::core
