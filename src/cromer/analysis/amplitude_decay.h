// How fast the amplitude of a free swing falls: the law's damping averaged over a cycle.
//
//   x'' = -w^2 x - 2 b x' - d x'|x'| - f sgn(x') - e x^2 x'   =>   dA/dt = -(s + b A + q A^2 + e A^3/8),
//   s = 2 f/(pi w),   q = 4 d w/(3 pi)
//
// First order in the damping over a cycle. Wang, Smith and Payne, Eur. J. Phys. 23, 155 (2002).
#pragma once

#include "cromer/analysis/cycle_average.h"
#include "cromer/model/oscillator.h"

namespace cromer::core {

template <class Real>
struct CycleDecay {
  Real angular_frequency = 1;   // [rad/s] > 0
  Oscillator<Real> per_mass{};  ///< terms that a law lacks are 0; hysteresis is not looked at

  /// -dA/dt over A [1/s] at amplitude A > 0 [unit]. It is also the viscous rate that takes as much energy in
  /// a cycle.
  Real rate(const Real& A) const {
    Real sum = 0;
    for_each_term([&]<class T>() {
      if constexpr (!HasInnerState<T>) {
        const Real& coefficient = per_mass.*T::template members<Real>[0];
        if (T::info.acts_at_rest || value_of(coefficient) == 0) return;
        sum += coefficient * (cycle_average<T>(A, angular_frequency).fall / A);
      }
    });
    return sum;
  }
};

using AmplitudeDecay = CycleDecay<double>;

}  // namespace cromer::core
