// How long the next step of an adaptive method may be.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/base/dual.h"
#include "cromer/base/state.h"
#include "cromer/methods/method.h"

namespace cromer {

/// What the caller sets: a plain number is the step.
struct StepControl {
  static constexpr double default_tolerance = 1e-9;

  double step;  // [s] > 0; of adaptive methods the spacing of the rows
  /// Of adaptive methods, 1e-15 to 1e-2: error of a step over the motion's scale.
  double tolerance = default_tolerance;
  /// [s] > 0, of adaptive methods: no longer steps, where a force acts so briefly that one could leap over
  /// it.
  double longest = std::numeric_limits<double>::infinity();

  StepControl(double step_, double tolerance_ = default_tolerance,  // NOLINT: a number is a step
              double longest_ = std::numeric_limits<double>::infinity())
      : step(step_), tolerance(tolerance_), longest(longest_) {}
};

/// The largest position and velocity of the motion so far: errors are measured by them.
class MotionScale {
 public:
  template <class Real>
  void include(const State<Real>& y) {
    x_ = std::max(x_, std::abs(value_of(y.x)));
    v_ = std::max(v_, std::abs(value_of(y.v)));
  }

  /// The larger of both relative errors of a step of length h to y, over the tolerance: at most 1 is good. An
  /// error that matters to neither position nor velocity within some hundred steps is none: else rounding
  /// would be all there is to see of a mass at rest.
  template <class Real>
  double norm(const Trial<Real>& trial, double h, double tolerance) const {
    const double x = std::max(x_, std::abs(value_of(trial.y.x)));
    const double v = std::max(v_, std::abs(value_of(trial.y.v)));
    const double x_error = std::abs(value_of(trial.error.x)), v_error = std::abs(value_of(trial.error.v));
    if (x_error == 0 && v_error == 0) return 0;
    return std::max(x_error / std::max(x, unseen * v * h), v_error / std::max(v, unseen * x / h)) / tolerance;
  }

 private:
  static constexpr double unseen = 1e-3;
  double x_ = 0, v_ = 0;  // [m], [m/s]
};

/// Proportional-integral control: K. Gustafsson, ACM Trans. Math. Softw. 17, 533 (1991), with the constants
/// of Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, 2nd ed., section II.4, and Hairer
/// & Wanner II, section IV.2.
class PiController {
 public:
  explicit PiController(int error_order)
      : integral_(1.0 / (error_order + 1) - 0.75 * proportional_), per_order_(1.0 / (error_order + 1)) {}

  /// The factor to the next step after an accepted one with this error (<= 1).
  double after_accepted(double error) {
    double factor = most;
    if (error > 0) factor = safety * std::pow(error, -integral_) * std::pow(last_, proportional_);
    last_ = std::max(error, 1e-4);
    const double limit = rejected_ ? 1.0 : most;
    rejected_ = false;
    return std::clamp(factor, least, limit);
  }

  /// The factor to the next try after a rejected step with this error (> 1 or not a number).
  double after_rejected(double error) {
    rejected_ = true;
    const double factor = safety * std::pow(error, -per_order_);
    return factor > least ? factor : least;
  }

 private:
  static constexpr double safety = 0.9, least = 0.2, most = 10, proportional_ = 0.04;
  double integral_, per_order_, last_ = 1e-4;
  bool rejected_ = false;
};

/// A first step [s]: the part tolerance^(1/(error order + 1)) of the time in which the acceleration changes
/// the state by as much as itself, |a| T^2 = |v| T + |x|; `otherwise` where there is no such
/// time. The controller corrects it.
template <class Real>
double first_step(const State<Real>& y, const Real& acceleration, double tolerance, int error_order,
                  double otherwise) {
  const double x = std::abs(value_of(y.x)), v = std::abs(value_of(y.v)), a = std::abs(value_of(acceleration));
  const double time = (v + std::sqrt(v * v + 4 * a * x)) / (2 * a);
  const double step = time * std::pow(tolerance, 1.0 / (error_order + 1));
  return step > 0 && std::isfinite(step) ? step : otherwise;
}

}  // namespace cromer
