// How long the next step of an adaptive method may be.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "cromer/base/bit_cast.h"
#include "cromer/base/coupled.h"
#include "cromer/base/dual.h"
#include "cromer/base/state.h"
#include "cromer/methods/method.h"

namespace cromer::core {

/// log2 x, for normal x > 0, in a few operations instead of some hundred cycles: controllers need no more
/// than three digits. Error: below 9e-4; exact at powers of 2.
inline double coarse_log2(double x) {
  constexpr std::uint64_t mantissa = (std::uint64_t{1} << 52) - 1, one = std::uint64_t{1023} << 52;
  const auto bits = bit_cast<std::uint64_t>(x);
  const double u = bit_cast<double>((bits & mantissa) | one) - 1;
  const auto exponent = static_cast<double>(static_cast<std::int64_t>(bits >> 52) - 1023);
  // The chord from 1 to 2, and a cubic that vanishes at both.
  return (exponent + u) + (u * (u - 1)) * (u * 0.15922 - 0.422865);
}

/// 2^y, likewise; y is limited to -1000 to 1000. Relative error: below 5e-6; exact for whole y.
inline double coarse_exp2(double y) {
  y = y < -1000 ? -1000 : y > 1000 ? 1000 : y;
  const std::int64_t whole = static_cast<std::int64_t>(y + 1023) - 1023;  // rounds down
  const double u = y - static_cast<double>(whole);
  const double bend = (0.306996 + u * 0.065446) + (u * u) * 0.013702;
  const double power = (1 + u) + (u * (u - 1)) * bend;
  return power * bit_cast<double>(static_cast<std::uint64_t>(whole + 1023) << 52);
}

/// What the caller sets: a plain number is the step.
struct StepControl {
  static constexpr double default_tolerance = 1e-9;

  double step;  // [s] > 0; of adaptive methods the spacing of the rows
  /// Of adaptive methods, 1e-15 to 1e-2: error of a step over the motion's scale.
  double tolerance = default_tolerance;

  StepControl(double step_, double tolerance_ = default_tolerance)  // NOLINT: a number is a step
      : step(step_), tolerance(tolerance_) {}
};

/// The largest position and velocity of the motion so far: errors are measured by them.
class MotionScale {
 public:
  template <class Real>
  void include(const State<Real>& y) {
    x_ = std::max(x_, std::abs(value_of(y.x)));
    v_ = std::max(v_, std::abs(value_of(y.v)));
    if constexpr (is_coupled<Real>) inner_ = std::max(inner_, std::abs(value_of(y.v.second)));
  }

  /// The larger of both relative errors of a step of length h to y, over the tolerance: at most 1 is good.
  /// An error that matters to neither position nor velocity within some hundred steps counts as none:
  /// otherwise the steps of a mass at rest would follow its rounding.
  template <class Real>
  [[gnu::always_inline]] double norm(const Trial<Real>& trial, double h, double tolerance) const {
    const double x = std::max(x_, std::abs(value_of(trial.y.x)));
    const double v = std::max(v_, std::abs(value_of(trial.y.v)));
    const double x_error = std::abs(value_of(trial.error.x)), v_error = std::abs(value_of(trial.error.v));
    double inner = 0;
    if constexpr (is_coupled<Real>) {
      // An inner state is measured by its own largest value: its law has corners that x and v hardly show.
      const double error = std::abs(value_of(trial.error.v.second));
      if (error != 0) inner = error / (tolerance * std::max(inner_, std::abs(value_of(trial.y.v.second))));
    }
    if (x_error == 0 && v_error == 0) return inner;
    const double way = v * h;  // both are compared as lengths
    return std::max({x_error / (tolerance * std::max(x, unseen * way)),
                     v_error * h / (tolerance * std::max(way, unseen * x)), inner});
  }

 private:
  static constexpr double unseen = 1e-3;
  double x_ = 0, v_ = 0;  // [m], [m/s]
  double inner_ = 0;      // in its own unit
};

/// Proportional-integral control: K. Gustafsson, ACM Trans. Math. Softw. 17, 533 (1991), with the constants
/// of Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, 2nd ed., section II.4, and Hairer
/// & Wanner II, section IV.2. Works with binary logarithms, known to three digits: no step needs more.
///
/// A step that could grow by less than a fifth stays as it is. Equal steps cost no accuracy for the work, the
/// system can keep what it has ready for a length, and above all the next step need not wait for the error of
/// the last: the processor runs ahead.
class PiController {
 public:
  explicit PiController(int error_order)
      : integral_(1.0 / (error_order + 1) - 0.75 * proportional), per_order_(1.0 / (error_order + 1)) {}

  /// The factor to the next step after an accepted one with this error (<= 1); exactly 1 where it is to stay.
  [[gnu::always_inline]] double after_accepted(double error) {
    const double size = coarse_log2(std::max(error, 1e-10));  // below it a step grows by the most allowed
    const double growth = safety + proportional * last_ - integral_ * size;
    last_ = std::max(size, least_last);
    const double limit = rejected_ ? 1.0 : most;
    rejected_ = false;
    if (growth >= 0 && growth < worthwhile) return 1;
    return std::clamp(coarse_exp2(growth), least, limit);
  }

  /// The factor to the next try after a rejected step with this error (> 1 or not a number).
  double after_rejected(double error) {
    rejected_ = true;
    const bool tells =
        error < 1e10;  // beyond, or without a number, it only says that the step was far too long
    return tells ? std::max(least, coarse_exp2(safety - per_order_ * coarse_log2(error))) : least;
  }

 private:
  static constexpr double least = 0.2, most = 10, proportional = 0.04;
  // Binary logarithms of 0.9, 1.2 and 1e-4.
  static constexpr double safety = -0.152, worthwhile = 0.263, least_last = -13.288;
  double integral_, per_order_;
  double last_ = least_last;  ///< binary logarithm of the last accepted step's error
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

}  // namespace cromer::core
