// Task: the local error of each method, what one step gets wrong, against the step.
#pragma once

#include <string>
#include <vector>

#include "cromer/result.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// The law and the methods are those of `simulate`; the steps are set here.
struct LocalErrorOptions {
  SimulateOptions simulate;
  double phase = 0.125;  ///< where in the free period the step starts, 0 to 1; at an eighth x and v are
                         ///< both far from zero
};

/// One method. Steps double, up to 1/20 of a period.
struct LocalErrorCurve {
  std::string method;
  std::vector<double> h;                 // [s]
  std::vector<double> x_error, v_error;  // [m], [m/s] absolute
  double x_slope = 0, v_slope = 0;       ///< fitted to log error against log h
  double x_over_predicted = 0;           ///< x_error over h^2/2 |F/m| at the smallest step: the first term
                                         ///< of Taylor's series that a first-order method lacks
  double v_over_predicted = 0;           ///< v_error over h^2/2 |d(F/m)/dt| at the smallest step
};

struct LocalErrorResult {
  std::vector<LocalErrorCurve> curves;  ///< in the order of the methods
};

/// The law must be linear and have a natural period; else the Error names what prevents it.
Result<LocalErrorResult> local_errors(const LocalErrorOptions& options);

}  // namespace cromer::core
