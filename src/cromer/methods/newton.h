// Newton's iteration for the one unknown of an implicit step.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/base/dual.h"

namespace cromer {

struct NewtonOptions {
  double tolerance = 1e-12;  ///< of the last update, relative to the motion's scale; 1e-15 to 1e-2
  int iteration_limit = 25;  ///< > 0

  friend bool operator==(const NewtonOptions&, const NewtonOptions&) = default;
};

template <class Real>
struct NewtonResult {
  Real root;
  int iterations;
  bool converged;
};

/// Sizes that tell when the iteration has arrived, in the unit of the unknown.
struct NewtonScale {
  double motion;    ///< the largest value of the motion so far; 0 before it begins
  double rounding;  ///< changes below it are lost in the other numbers of the equation
};

/// A root of residual(u), from the guess; the residual is called with a Dual, so that its derivative is
/// exact. Converged when an update is at most the tolerance times the motion (or the root itself, if larger);
/// or when updates no longer halve and are at rounding level (the given one, or a thousand roundings of the
/// motion): no equation in doubles can be solved better.
template <class Real, class Residual>
NewtonResult<Real> newton(const Residual& residual, const Real& guess, NewtonScale scale,
                          const NewtonOptions& options) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double last = std::numeric_limits<double>::infinity();
  Real u = guess;
  for (int i = 1; i <= options.iteration_limit; ++i) {
    const Dual<Real, 1> r = residual(Dual<Real, 1>::variable(u, 0));
    const Real update = r.value / r.derivative[0];
    u = u - update;
    const double size = std::abs(value_of(update)), motion = std::max(scale.motion, std::abs(value_of(u)));
    const bool stalled = size > 0.5 * last && size <= std::max(scale.rounding, 1e3 * epsilon * motion);
    if (size <= options.tolerance * motion || stalled) return {u, i, true};
    last = size;
  }
  return {u, options.iteration_limit, false};
}

}  // namespace cromer
