// Task: the error of a run against the evaluations that it takes, for each method.
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
  double longest = 0.1;     ///< first step, in periods of 1/200 of which `simulate` would step; > 0
  long long halvings = 10;  ///< of the step, > 0; adaptive methods: tolerances 1e-2, 1e-3, ... as many
};

/// One method. Runs that failed are left out.
struct WorkPrecisionCurve {
  std::string method;
  std::vector<double> evaluations;  ///< of the acceleration, increasing
  std::vector<double> error;        ///< of the final state, over the motion's largest: position and velocity
  double slope = 0;                 ///< of log error against log evaluations where the error is 1e-10 to 1e-3
};

struct WorkPrecisionResult {
  std::vector<WorkPrecisionCurve> curves;  ///< in the order of the methods
};

/// Against the closed form, or where there is none against dormand-prince at its finest tolerance.
Result<WorkPrecisionResult> work_precision(const WorkPrecisionOptions& options, const Watch& watch = {});

}  // namespace cromer::core
