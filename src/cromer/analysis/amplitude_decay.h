// How fast the amplitude of a free swing falls: the laws of damping averaged over a cycle.
//
//   x'' = -w^2 x - 2 b x' - d x'|x'| - f sgn(x')   =>   dA/dt = -(s + b A + q A^2),
//   s = 2 f/(pi w),   q = 4 d w/(3 pi)
//
// First order in the damping over a cycle. Wang, Smith and Payne, Eur. J. Phys. 23, 155 (2002).
#pragma once

#include <numbers>

namespace cromer {

/// Coefficients per unit mass, terms that a law lacks 0.
template <class Real>
struct CycleDecay {
  Real angular_frequency = 1;  // [rad/s] > 0
  Real decay_rate = 0;         // [1/s] b
  Real drag = 0;               // [1/unit] d
  Real friction = 0;           // [unit/s^2] f

  /// -dA/dt over A [1/s] at amplitude A > 0 [unit]: s/A + b + q A. It is also the viscous rate that takes as
  /// much energy in a cycle.
  Real rate(const Real& A) const {
    constexpr double pi = std::numbers::pi;
    return 2 * friction / (pi * angular_frequency) / A + decay_rate +
           4 * drag * angular_frequency / (3 * pi) * A;
  }
};

using AmplitudeDecay = CycleDecay<double>;

}  // namespace cromer
