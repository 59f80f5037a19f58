// Newton's iteration for the one or two unknowns of an implicit step.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cromer/base/dual.h"
#include "cromer/base/state.h"

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

/// Changes of an acceleration [m/s^2] that move neither x nor v by more than their last digits in a step h
/// [s].
template <class Real, class Time>
double acceleration_rounding(const State<Real>& y, const Time& h) {
  const double step = std::abs(value_of(h));
  return std::numeric_limits<double>::epsilon() * (std::abs(value_of(y.x)) / step + std::abs(value_of(y.v))) /
         step;
}

/// When an iteration has arrived. An update is at most the tolerance times the motion (or the root itself, if
/// larger); or updates no longer halve and are at rounding level (the given one, or a thousand roundings of
/// the motion): no equation in doubles can be solved better.
class NewtonArrival {
 public:
  NewtonArrival(NewtonScale scale, double tolerance) : scale_(scale), tolerance_(tolerance) {}

  /// Sizes of the latest update and of the root after it.
  bool operator()(double update, double root) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const double motion = std::max(scale_.motion, root);
    const bool stalled = update > 0.5 * last_ && update <= std::max(scale_.rounding, 1e3 * epsilon * motion);
    last_ = update;
    return update <= tolerance_ * motion || stalled;
  }

 private:
  NewtonScale scale_;
  double tolerance_, last_ = std::numeric_limits<double>::infinity();
};

/// A root of residual(u), from the guess; the residual is called with a Dual, so that its derivative is
/// exact.
template <class Real, class Residual>
NewtonResult<Real> newton(const Residual& residual, const Real& guess, NewtonScale scale,
                          const NewtonOptions& options) {
  NewtonArrival arrived(scale, options.tolerance);
  Real u = guess;
  for (int i = 1; i <= options.iteration_limit; ++i) {
    const Dual<Real, 1> r = residual(Dual<Real, 1>::variable(u, 0));
    const Real update = r.value / r.derivative[0];
    u = u - update;
    if (arrived(std::abs(value_of(update)), std::abs(value_of(u)))) return {u, i, true};
  }
  return {u, options.iteration_limit, false};
}

/// The same for two unknowns: residual takes and gives an array of two; sizes are those of the larger.
template <class Real, class Residual>
NewtonResult<std::array<Real, 2>> newton(const Residual& residual, const std::array<Real, 2>& guess,
                                         NewtonScale scale, const NewtonOptions& options) {
  using Unknown = Dual<Real, 2>;
  const auto size = [](const Real& a, const Real& b) {
    return std::max(std::abs(value_of(a)), std::abs(value_of(b)));
  };
  NewtonArrival arrived(scale, options.tolerance);
  std::array<Real, 2> u = guess;
  for (int i = 1; i <= options.iteration_limit; ++i) {
    const auto [r, s] =
        residual(std::array<Unknown, 2>{Unknown::variable(u[0], 0), Unknown::variable(u[1], 1)});
    const auto& [r0, r1] = r.derivative;
    const auto& [s0, s1] = s.derivative;
    const Real determinant = r0 * s1 - r1 * s0;
    const Real first = (r.value * s1 - r1 * s.value) / determinant;
    const Real second = (r0 * s.value - r.value * s0) / determinant;
    u = {u[0] - first, u[1] - second};
    const double update = size(first, second);
    // A comparison with NaN must not pass for a small update.
    if (std::isfinite(update) && arrived(update, size(u[0], u[1]))) return {u, i, true};
  }
  return {u, options.iteration_limit, false};
}

}  // namespace cromer
