// The smooth terms of the law as formulas, per unit mass: written here alone, whoever chooses among them
// when.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "cromer/base/dual.h"
#include "cromer/model/oscillator.h"
#include "cromer/model/propagate.h"

namespace cromer {

/// k x + k3 x^3 over m [m/s^2]; k x alone without `cubic`. T is Real, or a Dual over it.
template <bool cubic, class Real, class T>
T restoring_term(const Oscillator<Real>& per_mass, const T& x) {
  if constexpr (cubic)
    return per_mass.stiffness * x + (per_mass.cubic * x) * (x * x);  // two products deep, not three
  else
    return per_mass.stiffness * x;
}

/// (c + d |v|) v over m [m/s^2]; c v alone without `drag`.
template <bool drag, class Real, class T>
T resistance_term(const Oscillator<Real>& per_mass, const T& v) {
  using std::abs;
  if constexpr (drag)
    return (per_mass.damping + per_mass.drag * abs(v)) * v;
  else
    return per_mass.damping * v;
}

/// w0^2 sin x [rad/s^2]: a pendulum's in place of k x.
template <class Real, class T>
T pendulum_term(const Real& stiffness, const T& x) {
  using std::sin;
  return stiffness * sin(x);
}

/// From one zero of the free motion's velocity to the next [s]: half a period; infinite where it does not
/// swing.
inline double zero_spacing(const LinearLaw<double>& law) {
  const double squared = law.stiffness - law.decay_rate * law.decay_rate;
  return squared > 0 ? std::numbers::pi / std::sqrt(squared) : std::numeric_limits<double>::infinity();
}

}  // namespace cromer
