// Task: the damping and the frequency that each method really simulates, against the step.
#pragma once

#include <string>
#include <vector>

#include "cromer/base/result.h"
#include "cromer/study/task/simulate.h"

namespace cromer {

/// The linear law and the methods are those of `simulate`; the steps are set here.
struct MethodMapOptions {
  SimulateOptions simulate;
  double from = 0.02;      ///< shortest w h, > 0
  double to = 2.5;         ///< longest w h, > from
  long long points = 200;  ///< >= 2, evenly spaced in log(w h)
};

/// One method. NaN where its motion does not oscillate or no step is found.
struct MethodMapCurve {
  std::string method;
  std::vector<double> wh;               ///< natural frequency times step
  std::vector<double> decay_rate;       // [1/s]
  std::vector<double> frequency_error;  ///< |effective over the law's own damped frequency - 1|
  std::vector<double> decay_error;      ///< |effective decay rate - the law's| over the natural frequency
};

struct MethodMapResult {
  double natural_frequency = 0;        // [rad/s]
  double decay_rate = 0;               // [1/s] of the law
  std::vector<MethodMapCurve> curves;  ///< in the order of the methods
};

/// Of an underdamped linear law; adaptive methods are refused.
Result<MethodMapResult> method_map(const MethodMapOptions& options);

}  // namespace cromer
