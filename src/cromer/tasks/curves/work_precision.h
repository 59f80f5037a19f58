// Task: the error of each method against its cost, the evaluations of the acceleration.
#pragma once

#include <string>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/result.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// The law, its drive, the end and the methods are those of `simulate`; steps and tolerances are set here.
struct WorkPrecisionOptions {
  SimulateOptions simulate;
  double longest =
      0.1;  ///< first step, > 0, as a share of a period, which is 200 default steps of `simulate`
  long long halvings = 10;  ///< of the step, 1 to 30; adaptive methods: as many tolerances 1e-2, 1e-3, ...
};

/// One method. Runs that failed are left out.
struct WorkPrecisionCurve {
  std::string method;
  std::vector<double> evaluations;  ///< of the acceleration, increasing
  std::vector<double> error;        ///< of the final position or velocity, relative to its largest value
  double slope = 0;                 ///< of log error against log evaluations where the error is 1e-10 to 1e-3
};

struct WorkPrecisionResult {
  std::vector<WorkPrecisionCurve> curves;  ///< in the order of the methods
};

/// Errors are taken against the closed form; for a law without one, against dormand-prince at tolerance
/// 1e-14.
Result<WorkPrecisionResult> work_precision(const WorkPrecisionOptions& options, const Watch& watch = {});

}  // namespace cromer::core
