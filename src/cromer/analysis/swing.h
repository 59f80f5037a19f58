// Amplitude and frequency of an undamped swing of any size, under the law's springs.
//
// With u = a cos(theta) about the middle of the swing, theta'^2 has no zero between the turning points, and
// the period is the integral of 1/theta' over a full turn: of a periodic function, so that the midpoint rule
// converges faster than any power (Trefethen & Weideman, SIAM Review 56, 385 (2014)).
#pragma once

#include <cmath>
#include <numbers>

#include "cromer/analysis/gauss_rule.h"
#include "cromer/base/dual.h"
#include "cromer/model/oscillator.h"
#include "cromer/model/terms/all.h"

namespace cromer::core {

template <class Real>
struct Swing {
  Oscillator<Real> per_mass{};  ///< terms that a law lacks are 0; dampings are not looked at, nor hysteresis

  /// [unit^2/s^2] of the springs, 0 at rest.
  Real potential(const Real& x) const {
    Real sum = 0;
    for_each_term([&]<class T>() {
      if constexpr (requires { T::energy(x, x); })
        if (value_of(per_mass.*T::template members<Real>[0]) != 0)
          sum += T::energy(x, per_mass.*T::template members<Real>[0]);
    });
    return sum;
  }

  /// [unit/s^2] with which they pull back.
  Real pull(const Real& x) const {
    Real sum = 0;
    for_each_term([&]<class T>() {
      if constexpr (requires { T::energy(x, x); })
        if (value_of(per_mass.*T::template members<Real>[0]) != 0)
          sum += T::force(x, x, per_mass.*T::template members<Real>[0]);
    });
    return sum;
  }

  /// Of small swings [1/s^2].
  Real stiffness() const { return per_mass.stiffness + per_mass.pendulum; }

  /// How far the swing goes to the right that passes x [unit] at v [unit/s]: its turning point has all of the
  /// energy. A spring that gives way before it counts as linear, a pendulum that goes over the top as one that
  /// stops there.
  Real amplitude(const Real& x, const Real& v) const {
    using std::abs, std::sqrt;
    const Real energy = 0.5 * (v * v) + potential(x);
    const Real linear = sqrt(2.0 * energy / stiffness());
    const double most = value_of(per_mass.pendulum) != 0 ? std::numbers::pi : HUGE_VAL;
    if (most < HUGE_VAL && value_of(energy) >= value_of(potential(Real(most)))) return Real(most);
    Real A = linear;
    for (int newton = 0; newton < 60; ++newton) {
      const Real pulled = pull(A);
      if (!(value_of(pulled) > 0)) return linear;
      Real step = (potential(A) - energy) / pulled;
      // Not further than half of it at once: past the top of a pendulum, or the end of a spring, is nothing.
      if (std::abs(value_of(step)) > 0.5 * value_of(A)) step = Real((value_of(step) > 0 ? 0.5 : -0.5)) * A;
      A -= step;
      if (value_of(A) > most) A = Real(most) - 1e-3 * Real(1.0);
      if (newton > 4 && std::abs(value_of(step)) < 1e-15 * value_of(A)) break;
    }
    return value_of(A) < 1e3 * value_of(linear) ? A : linear;
  }

  /// [rad/s] when it goes `a` [unit] > 0 to each side of its middle; NaN where it would not come back. Error:
  /// 1e-12 of it as long as stiffness keeps more than a twentieth of w0^2 throughout; an angle up to 3 rad.
  Real angular_frequency(const Real& a) const {
    using std::sqrt;
    constexpr int points = 96;
    // The middle c: the potential is the same at c + a and c - a.
    Real c = 0;
    if (value_of(per_mass.quadratic) != 0)
      for (int newton = 0; newton < 12; ++newton)
        c -= (potential(c + a) - potential(c - a)) / (pull(c + a) - pull(c - a));
    const auto force = [&](const Real& x) { return pull(x); };
    Real sum = 0;
    for (int i = 0; i < points; ++i) {
      const double share = std::cos((i + 0.5) * std::numbers::pi / points);
      const Real u = share * a;
      // theta'^2, from the turning point on its own side: energies would cancel there.
      const Real square = share > 0 ? 2.0 * mean_over(Real(c + u), Real(c + a), force) / (a + u)
                                    : -2.0 * mean_over(Real(c - a), Real(c + u), force) / (a - u);
      sum += Real(1.0) / sqrt(square);
    }
    return Real(static_cast<double>(points)) / sum;
  }
};

}  // namespace cromer::core
