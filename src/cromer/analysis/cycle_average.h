// What a term of the law does to a swing, averaged over a cycle: how fast its amplitude falls and by how much its
// frequency rises.
//
// With x = A cos(theta), v = -A w sin(theta) and a force f per unit mass beside w^2 x:
//   dA/dt = (1/w) <f sin(theta)>,   d(phase)/dt - w = 1/(A w) <f cos(theta)>,
// first order in f. N. N. Bogoliubov & Y. A. Mitropolsky, Asymptotic Methods (1961), chapter 1. So
//   viscous 2 b x': dA/dt = -b A;  drag d x'|x'|: -4 d w A^2/(3 pi);  friction f: -2 f/(pi w);
//   van der Pol e x^2 x': -e A^3/8;  cubic k3 x^3: w + 3 k3 A^2/(8 w);  odd quadratic ka x|x|: w + 4 ka A/(3 pi w);
//   quintic k5 x^5: w + 5 k5 A^4/(16 w).
#pragma once

#include <cmath>
#include <numbers>

#include "cromer/analysis/gauss_rule.h"
#include "cromer/base/dual.h"
#include "cromer/model/terms/all.h"

namespace cromer::core {

template <class Real>
struct CycleAverage {
  Real fall = 0;   // [unit/s] -dA/dt
  Real shift = 0;  // [rad/s] of the frequency
};

/// Of a term with a coefficient of 1 per unit mass, at amplitude A > 0 and w > 0 [rad/s]: Gauss's rule in
/// each quarter of the cycle, where no force jumps or bends; to 1e-10, of a pendulum to 1e-9 at 2 rad.
/// Exactly 0 where the quarters cancel.
template <class Term, class Real>
CycleAverage<Real> cycle_average(const Real& A, const Real& w) {
  using std::abs;
  CycleAverage<Real> average;
  Real falls = 0, shifts = 0;  // without signs
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double from = quarter * std::numbers::pi / 2, to = from + std::numbers::pi / 2;
    const auto force = [&](double theta) {
      return Term::force(Real(std::cos(theta) * A), Real(-std::sin(theta) * (A * w)), Real(1.0));
    };
    const Real fall =
        mean_over(from, to, [&](double theta) { return Real(std::sin(theta) * force(theta)); }) / (4.0 * w);
    const Real shift =
        mean_over(from, to, [&](double theta) { return Real(std::cos(theta) * force(theta)); }) / (4.0 * (A * w));
    average.fall -= fall;
    falls += abs(fall);
    average.shift += shift;
    shifts += abs(shift);
  }
  constexpr double rounding = 1e-13;
  if (abs(average.fall) <= rounding * falls) average.fall = 0;
  if (abs(average.shift) <= rounding * shifts) average.shift = 0;
  return average;
}

}  // namespace cromer::core
