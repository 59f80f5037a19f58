// Task: what one step of a method misses, against its length.
#pragma once

#include <string>
#include <vector>

#include "cromer/result.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// The law and the methods are those of `simulate`; steps are set here.
struct LocalErrorOptions {
  SimulateOptions simulate;
  double phase = 0.125;  ///< where in the free motion's period the step starts, 0 to 1: an eighth, where x
                         ///< and v are both far from zero
};

/// One method. Steps double, up to 1/20 of a period.
struct LocalErrorCurve {
  std::string method;
  std::vector<double> h;                 // [s]
  std::vector<double> x_error, v_error;  // [m], [m/s] absolute
  double x_slope = 0, v_slope = 0;       ///< fitted to log error against log h
  double x_over_predicted = 0;  ///< x_error over h^2/2 |F/m| at the smallest step: the first term that
                                ///< Taylor's series has and a first-order method has not
  double v_over_predicted = 0;  ///< v_error over h^2/2 |d(F/m)/dt| at the smallest step
};

struct LocalErrorResult {
  std::vector<LocalErrorCurve> curves;  ///< in the order of the methods
};

/// Of a linear law with a natural period; an Error names what prevents it.
Result<LocalErrorResult> local_errors(const LocalErrorOptions& options);

}  // namespace cromer::core
