// Amplitude and frequency of a swing: under the law's springs alone, what each term of the law does to them,
// averaged over a cycle, and the limit cycle of a swing that negative damping feeds.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <type_traits>

#include "cromer/base/dual.h"
#include "cromer/model/oscillator.h"
#include "cromer/model/terms/all.h"

namespace cromer::core {

/// Gauss's rule: nodes on either side of the middle of [-1, 1] and the weights of a mean. M. Abramowitz & I.
/// A. Stegun, Handbook, table 25.4.
inline constexpr double gauss_node[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                        0.9602898564975363};
inline constexpr double gauss_weight[] = {0.5 * 0.3626837833783620, 0.5 * 0.3137066458778873,
                                          0.5 * 0.2223810344533745, 0.5 * 0.1012285362903763};

/// The mean of f over [from, to]; f may give another type than its argument's.
template <class T, class F>
auto mean_over(const T& from, const T& to, const F& f) {
  const T middle = 0.5 * (from + to), half = 0.5 * (to - from);
  decltype(f(middle)) sum = 0.0;
  for (int i = 0; i < 4; ++i)
    sum += gauss_weight[i] * (f(T(middle + gauss_node[i] * half)) + f(T(middle - gauss_node[i] * half)));
  return sum;
}

// Under the springs alone, exactly. With u = a cos(theta) about the middle of the swing, theta'^2 has no zero
// between the turning points, and the period is the integral of 1/theta' over a full turn. That is a periodic
// function, so the midpoint rule converges faster than any power (Trefethen & Weideman, SIAM Review 56, 385
// (2014)).

template <class Real>
struct Swing {
  Oscillator<Real> per_mass{};  ///< terms that a law lacks are 0; damping and hysteresis are ignored

  /// Potential energy of the springs per unit mass [unit^2/s^2]; 0 at rest.
  Real potential(const Real& x) const {
    Real sum = 0;
    for_each_term([&]<class T>() {
      if constexpr (requires { T::energy(x, x); })
        if (value_of(per_mass.*T::template members<Real>[0]) != 0)
          sum += T::energy(x, per_mass.*T::template members<Real>[0]);
    });
    return sum;
  }

  /// Restoring force of the springs per unit mass [unit/s^2].
  Real pull(const Real& x) const {
    Real sum = 0;
    for_each_term([&]<class T>() {
      if constexpr (requires { T::energy(x, x); })
        if (value_of(per_mass.*T::template members<Real>[0]) != 0)
          sum += T::force(x, x, per_mass.*T::template members<Real>[0]);
    });
    return sum;
  }

  /// Stiffness per unit mass of small swings [1/s^2].
  Real stiffness() const { return per_mass.stiffness + per_mass.pendulum; }

  /// Amplitude [unit] of the swing that passes x [unit] at v [unit/s]: half the way between its turning
  /// points, where all energy is potential. A spring that gives way before is taken as linear, one that gives
  /// way on the left alone as it is on the right. A pendulum that would go over the top is taken to stop
  /// there.
  Real amplitude(const Real& x, const Real& v) const {
    using std::sqrt;
    const Real energy = 0.5 * (v * v) + potential(x);
    const Real linear = sqrt(2.0 * energy / stiffness());
    const auto right = reach(energy, linear, 1);
    if (!right) return linear;
    if (value_of(per_mass.quadratic) == 0) return *right;
    const auto left = reach(energy, linear, -1);
    return left ? 0.5 * (*right + *left) : *right;
  }

  /// Angular frequency [rad/s] of a swing that goes `a` [unit] > 0 to each side of its middle; NaN where it
  /// would not come back. Relative error: 1e-12 as long as the stiffness stays above w0^2/20 throughout; of
  /// a pendulum up to 3 rad. Fewer points are enough for a start.
  Real angular_frequency(const Real& a, int points = 96) const {
    const Real c = middle(a);
    Real sum = 0;
    for (int i = 0; i < points; ++i)
      sum += Real(1.0) / turning(c, a, std::cos((i + 0.5) * std::numbers::pi / points));
    return Real(static_cast<double>(points)) / sum;
  }

  /// The middle c of a swing of amplitude a: the potential is the same at c + a and c - a.
  Real middle(const Real& a) const {
    Real c = 0;
    if (value_of(per_mass.quadratic) != 0)
      for (int newton = 0; newton < 12; ++newton)
        c -= (potential(c + a) - potential(c - a)) / (pull(c + a) - pull(c - a));
    return c;
  }

  /// theta' [rad/s] at u = a cos(theta) from the middle c, where the cosine is `share`.
  Real turning(const Real& c, const Real& a, double share) const {
    using std::sqrt;
    const auto force = [&](const Real& x) { return pull(x); };
    const Real u = share * a;
    // From the turning point on its own side: energies would cancel there.
    return sqrt(share > 0 ? 2.0 * mean_over(Real(c + u), Real(c + a), force) / (a + u)
                          : -2.0 * mean_over(Real(c - a), Real(c + u), force) / (a - u));
  }

  /// How far the swing goes to the right (side 1) or the left (-1) of 0, beginning at `linear`; empty where
  /// the spring gives way before.
  std::optional<Real> reach(const Real& energy, const Real& linear, double side) const {
    using std::abs;
    const double most = value_of(per_mass.pendulum) != 0 ? std::numbers::pi : HUGE_VAL;
    if (most < HUGE_VAL && value_of(energy) >= value_of(potential(Real(side * most)))) return Real(most);
    Real A = linear;
    for (int newton = 0; newton < 60; ++newton) {
      const Real pulled = side * pull(side * A);
      if (!(value_of(pulled) > 0)) return std::nullopt;
      Real step = (potential(side * A) - energy) / pulled;
      // At most half of A at once: there is no solution beyond a pendulum's top or a spring's end.
      if (abs(value_of(step)) > 0.5 * value_of(A)) step = Real((value_of(step) > 0 ? 0.5 : -0.5)) * A;
      A -= step;
      if (value_of(A) > most) A = Real(most) - 1e-3 * Real(1.0);
      if (newton > 4 && abs(value_of(step)) < 1e-15 * value_of(A)) break;
    }
    if (value_of(A) < 1e3 * value_of(linear)) return A;
    return std::nullopt;
  }

  /// Whether a spring beside the linear one acts.
  bool is_bent() const {
    bool bent = false;
    for_each_term([&]<class T>() {
      if constexpr (requires(const Real& x) { T::energy(x, x); } && !std::is_same_v<T, Spring>)
        bent = bent || value_of(per_mass.*T::template members<Real>[0]) != 0;
    });
    return bent;
  }
};

// Averaged over a cycle, to the first order in the force. With x = A cos(theta), v = -A w sin(theta) and a
// force f per unit mass beside w^2 x (N. N. Bogoliubov & Y. A. Mitropolsky, Asymptotic Methods (1961),
// chapter 1):
//   dA/dt = (1/w) <f sin(theta)>,   d(phase)/dt - w = 1/(A w) <f cos(theta)>. So
//   viscous 2 b x': dA/dt = -b A;  drag d x'|x'|: -4 d w A^2/(3 pi);  friction f: -2 f/(pi w);
//   van der Pol e x^2 x': -e A^3/8;  cubic k3 x^3: w + 3 k3 A^2/(8 w);  odd quadratic ka x|x|: w + 4 ka A/(3
//   pi w); quintic k5 x^5: w + 5 k5 A^4/(16 w).

template <class Real>
struct CycleAverage {
  Real fall = 0;   // [unit/s] -dA/dt
  Real shift = 0;  // [rad/s] change of the frequency
};

/// A place in the cycle.
struct CyclePhase {
  double cosine, sine;
};

/// The nodes of mean_over() in each quarter of the cycle, two and two about its middle.
inline const std::array<std::array<std::array<CyclePhase, 2>, 4>, 4>& cycle_nodes() {
  static const auto nodes = [] {
    std::array<std::array<std::array<CyclePhase, 2>, 4>, 4> all{};
    for (int quarter = 0; quarter < 4; ++quarter)
      for (int i = 0; i < 4; ++i)
        for (int side = 0; side < 2; ++side) {
          const double from = quarter * std::numbers::pi / 2, to = from + std::numbers::pi / 2;
          const double off = gauss_node[i] * (0.5 * (to - from)), middle = 0.5 * (from + to);
          const double theta = side == 0 ? middle + off : middle - off;
          all[quarter][i][side] = {std::cos(theta), std::sin(theta)};
        }
    return all;
  }();
  return nodes;
}

/// The averages of a term with a coefficient of 1 per unit mass, at amplitude A > 0 and w > 0 [rad/s]: by
/// Gauss's rule in each quarter of the cycle, within which no force jumps or bends. Relative error: 1e-10,
/// of a pendulum at 2 rad 1e-9. Exactly 0 where the quarters cancel.
template <class Term, class Real>
CycleAverage<Real> cycle_average(const Real& A, const Real& w) {
  using std::abs;
  CycleAverage<Real> average;
  Real falls = 0, shifts = 0;  // without signs
  const auto& nodes = cycle_nodes();
  for (int quarter = 0; quarter < 4; ++quarter) {
    Real by_sine = 0, by_cosine = 0;
    for (int i = 0; i < 4; ++i) {
      const auto& [one, other] = nodes[quarter][i];
      const auto force = [&](const CyclePhase& at) {
        return Real(Term::force(Real(at.cosine * A), Real(-at.sine * (A * w)), Real(1.0)));
      };
      const Real of_one = force(one), of_other = force(other);
      by_sine += gauss_weight[i] * (one.sine * of_one + other.sine * of_other);
      by_cosine += gauss_weight[i] * (one.cosine * of_one + other.cosine * of_other);
    }
    const Real fall = by_sine / (4.0 * w), shift = by_cosine / (4.0 * (A * w));
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

// All dampings together (Wang, Smith and Payne, Eur. J. Phys. 23, 155 (2002)):
//
//   x'' = -w^2 x - 2 b x' - d x'|x'| - f sgn(x') - e x^2 x'   =>   dA/dt = -(s + b A + q A^2 + e A^3/8),
//   s = 2 f/(pi w),   q = 4 d w/(3 pi)

template <class Real>
struct CycleDecay {
  Real angular_frequency = 1;   // [rad/s] > 0; `rate` does not use it where a spring is bent
  Oscillator<Real> per_mass{};  ///< terms that a law lacks are 0; hysteresis is ignored

  /// (-dA/dt)/A [1/s] at amplitude A > 0 [unit], half the way from one turning point to the next: to the
  /// first order in what damps, however far the springs are bent.
  Real rate(const Real& A) const {
    if (const Swing<Real> swing{per_mass}; swing.is_bent())
      if (const Real bent = rate_of(swing, A); std::isfinite(value_of(bent))) return bent;
    return equivalent_rate(A);
  }

  /// The decay rate [1/s] of the viscous law that takes as much energy in a cycle: the same but for bent
  /// springs, whose energy does not grow with the square of the amplitude.
  Real equivalent_rate(const Real& A) const {
    Real sum = 0;
    for_each_term([&]<class T>() {
      if constexpr (!HasInnerState<T>) {
        const Real& coefficient = per_mass.*T::template members<Real>[0];
        if (T::info.acts_at_rest || vanishes(coefficient)) return;
        sum += coefficient * (cycle_average<T>(A, angular_frequency).fall / A);
      }
    });
    return sum;
  }

 private:
  /// What is lost in half a cycle, over what the energy grows by with the amplitude: with p and q the pulls
  /// at the two turning points, dE/da = 2 p q/(p + q), as both move.
  Real rate_of(const Swing<Real>& swing, const Real& a) const {
    const Real c = swing.middle(a), p = swing.pull(c + a), q = -swing.pull(c - a);
    Real lost = 0, time = 0;
    for (const double from : {0.0, std::numbers::pi / 2}) {
      const double to = from + std::numbers::pi / 2;
      lost += mean_over(from, to, [&](double theta) {
        const Real way = std::sin(theta) * a;
        return -way * damping(Real(c + std::cos(theta) * a), -way * swing.turning(c, a, std::cos(theta)));
      });
      time += mean_over(from, to,
                        [&](double theta) { return Real(Real(1.0) / swing.turning(c, a, std::cos(theta))); });
    }
    return lost / time * (p + q) / (2.0 * (p * q * a));
  }

  /// The force per unit mass against the motion.
  Real damping(const Real& x, const Real& v) const {
    Real sum = 0;
    for_each_term([&]<class T>() {
      if constexpr (!HasInnerState<T>) {
        const Real& coefficient = per_mass.*T::template members<Real>[0];
        if (!T::info.acts_at_rest && !vanishes(coefficient)) sum += T::force(x, v, coefficient);
      }
    });
    return sum;
  }
};

using AmplitudeDecay = CycleDecay<double>;

// The limit cycle.

/// The largest displacement [unit] of the limit cycle of an oscillator per unit mass without hysteresis:
/// the turning point from which the next one on the same side is as far out (H. Poincaré's map). Found by
/// secants from `near` > 0, an amplitude close to it; `period` > 0 [s] is roughly that of the swing. Error:
/// 1e-8 of it where the forces are smooth. Empty where none is found.
std::optional<double> limit_cycle_amplitude(const Oscillator<double>& per_mass, double near, double period);

}  // namespace cromer::core
