// A recorded motion, as the estimator sees it.
#pragma once

#include <span>

namespace cromer {

/// Times [s], strictly increasing, and values of the same length in any unit; no NaN in either.
struct Record {
  std::span<const double> t;
  std::span<const double> y;
  double resolution = 0;  ///< rounding step of the values, 0 if unknown
  int derivative = 0;     ///< which of the displacement y is: 0 itself, 1 the velocity, 2 the acceleration
};

}  // namespace cromer
