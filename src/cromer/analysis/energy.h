// The energy stored in the oscillator, and the modified energy that Euler-Cromer conserves in its place.
#pragma once

#include <algorithm>
#include <cmath>

#include "cromer/base/state.h"
#include "cromer/model/law_force.h"
#include "cromer/model/oscillator.h"

namespace cromer::core {

/// The energy at y; `coefficients` are given as sum_of_forces takes them.
template <Law law, class Source, class Real>
Real energy(const Real& mass, const Source& coefficients, [[maybe_unused]] Law present,
            const State<Real>& y) {
  Real sum = mass * (y.v * y.v) / Real(2);
  for_each_term([&]<class T>() {
    if constexpr (terms_of_position.has<T>() && (law == any_terms || law.has<T>())) {
      if (law == any_terms && !present.has<T>()) return;
      sum = sum + T::energy(y.x, coefficient_of<T>(coefficients));
    }
  });
  return sum;
}

/// Kinetic energy and what each term stores [J]: m v^2/2 + k x^2/2 + k3 x^4/4 + ... Negative in a double
/// well. What hysteresis stores is left out: it is no function of x and v.
template <class Real>
Real energy(const Oscillator<Real>& oscillator, const State<Real>& y) {
  return energy<any_terms>(oscillator.mass, oscillator, law_of(oscillator), y);
}

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
