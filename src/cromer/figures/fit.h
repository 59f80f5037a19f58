// Measured samples, the fitted law and what is left between them.
#pragma once

#include <vector>

#include "cromer/report/figure.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// Motion and residual of each recording that could be fitted, one above the other, and what else its fit
/// shows (decay, samples held out, hysteretic swings); measured samples alone of one that could not. More
/// than three recordings stand in a grid.
Figure fit_figure(const std::vector<FittedRecording>& fits);

}  // namespace cromer::core
