// What a method keeps of the undamped linear oscillator, beside the energy itself.
#pragma once

#include <algorithm>
#include <cmath>

#include "cromer/base/state.h"
#include "cromer/model/oscillator.h"

namespace cromer::core {

/// m/2 (v^2 + w^2 x^2 - h w^2 x v) [J], w^2 = k/m: what Euler-Cromer with steps of h [s] conserves exactly,
/// where the energy itself swings by about w h/2. Of the linear law without damping, drag, friction and
/// drive; a closed ellipse for w h < 2. E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration,
/// 2nd ed., Springer 2006, I.1.
template <class Real>
constexpr Real modified_energy(const Oscillator<Real>& oscillator, double h, const State<Real>& y) {
  return (oscillator.mass * (y.v * y.v) + oscillator.stiffness * (y.x * y.x - h * (y.x * y.v))) / Real(2);
}

/// What became of the modified energy over the kept states of a run, and of the energy itself.
struct ModifiedEnergy {
  double start = 0, end = 0;  // [J]
  double drift = 0;           ///< the largest change over the start
  double energy_swing = 0;  ///< of the energy itself: half of what lies between its extremes, over their mean
  long long states = 0;     ///< looked at
};

/// Follows a quantity that should not change.
class Drift {
 public:
  void operator()(double value) {
    if (!begun_) first_ = value;
    begun_ = true;
    largest_ = std::max(largest_, std::abs(value - first_));
  }

  /// The largest change from the first value, over the first value's size; 0 before there is one.
  double largest() const { return largest_ == 0 ? 0 : largest_ / std::abs(first_); }

 private:
  bool begun_ = false;
  double first_ = 0, largest_ = 0;
};

}  // namespace cromer::core
