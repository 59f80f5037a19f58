// The figure of a sweep: a curve, a family of curves, or a map.
#pragma once

#include "cromer/report/figure.h"
#include "cromer/result.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

/// One panel for each measure. Over one option a curve; over two, of which the outer takes at most five
/// values, a curve for each of them, else a map. An Error where more than two are swept.
Result<Figure> sweep_figure(const SweepResult& result);

}  // namespace cromer::core
