// Amplitude and frequency of an undamped swing of any size.
//
//   x'' = -w0^2 x - k2 x^2 - k3 x^3,   or for a pendulum w0^2 sin x in place of w0^2 x
//
// With u = a cos(theta) about the middle of the swing, theta'^2 has no zero between the turning points, and
// the period is the integral of 1/theta' over a full turn: of a periodic function, so that the midpoint rule
// converges faster than any power (Trefethen & Weideman, SIAM Review 56, 385 (2014)).
#pragma once

#include <cmath>
#include <numbers>

#include "cromer/base/dual.h"

namespace cromer {

/// Coefficients per unit mass.
template <class Real>
struct Swing {
  Real stiffness = 1;  // [1/s^2] w0^2 > 0
  Real quadratic = 0;  // [1/(unit s^2)] k2, none with a pendulum
  Real cubic = 0;      // [1/(unit^2 s^2)] k3
  bool pendulum = false;

  /// How far the swing goes that passes x [unit] at v [unit/s]: its turning point has all of the energy.
  /// quadratic is 0. A spring that gives way before it counts as linear, a pendulum that goes over the top as
  /// one that stops there.
  Real amplitude(const Real& x, const Real& v) const;

  /// [rad/s] when it goes `a` [unit] > 0 to each side of its middle; NaN where it would not come back. Error:
  /// 1e-12 of it as long as stiffness keeps more than a twentieth of w0^2 throughout; an angle up to 3 rad.
  Real angular_frequency(const Real& a) const;
};

template <class Real>
Real Swing<Real>::amplitude(const Real& x, const Real& v) const {
  using std::atan2, std::sin, std::sqrt;
  const Real x2 = x * x, kinetic = 0.5 * v * v;
  if (!pendulum) {
    const Real energy = kinetic + 0.5 * stiffness * x2 + 0.25 * cubic * x2 * x2;
    const Real root = stiffness * stiffness + 4 * cubic * energy;
    if (!(root > 0)) return sqrt(2 * energy / stiffness);
    return sqrt(4 * energy / (stiffness + sqrt(root)));
  }
  const Real half = sin(0.5 * x);
  const Real energy = kinetic + 2 * stiffness * half * half + 0.25 * cubic * x2 * x2;
  const Real height = energy / (2 * stiffness);  // sin^2(A/2) where nothing is cubic
  if (!(height < 1)) return Real(std::numbers::pi);
  Real A = 2 * atan2(sqrt(height), sqrt(1 - height));
  if (cubic == Real(0)) return A;
  for (int newton = 0; newton < 12; ++newton) {
    const Real s = sin(0.5 * A);
    const Real excess = 2 * stiffness * s * s + 0.25 * cubic * A * A * A * A - energy;
    A -= excess / (stiffness * sin(A) + cubic * A * A * A);
  }
  return A;
}

template <class Real>
Real Swing<Real>::angular_frequency(const Real& a) const {
  using std::sin, std::sqrt;
  constexpr int points = 96;
  const Real a2 = a * a;
  // The middle c: the potential is the same at c + a and c - a.
  Real c = 0;
  if (!(quadratic == Real(0))) {
    for (int newton = 0; newton < 12; ++newton) {
      const Real unequal = stiffness * c + quadratic * (c * c + a2 / 3) + cubic * c * (c * c + a2);
      c -= unequal / (stiffness + 2 * quadratic * c + cubic * (3 * c * c + a2));
    }
  }
  // The potential about it, in powers of u; its odd part vanishes at u = a.
  const Real second = (pendulum ? Real(0) : 0.5 * stiffness) + quadratic * c + 1.5 * cubic * c * c;
  const Real third = quadratic / 3 + cubic * c, fourth = 0.25 * cubic;
  Real sum = 0;
  for (int i = 0; i < points; ++i) {
    const Real u = a * std::cos((i + 0.5) * std::numbers::pi / points);
    Real square = 2 * (second + third * u + fourth * (a2 + u * u));  // of theta'
    if (pendulum) {
      const Real above = 0.5 * (a + u), below = 0.5 * (a - u);
      square += stiffness * (sin(above) / above) * (sin(below) / below);
    }
    sum += 1 / sqrt(square);
  }
  return points / sum;
}

}  // namespace cromer
