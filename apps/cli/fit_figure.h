// Measured samples, the fitted law and what is left between them.
#pragma once

#include <vector>

#include "cromer/report/figure.h"
#include "cromer/study/task/fit.h"

namespace cromer::cli {

/// Two panels for each recording that could be fitted, one above the other: motion and residual; one panel of
/// measured samples otherwise.
Figure fit_figure(const std::vector<FittedRecording>& fits);

}  // namespace cromer::cli
