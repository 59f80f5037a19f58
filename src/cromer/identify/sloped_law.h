// The acceleration of a law of free motion with its derivatives, by the law's own slopes.
//
// Dual numbers carried through every product of the law would compute each derivative several times over.
#pragma once

#include <cmath>
#include <cstddef>

#include "cromer/base/dual.h"
#include "cromer/identify/law.h"
#include "cromer/model/oscillator.h"
#include "cromer/model/terms.h"

namespace cromer {

/// The smooth terms: x'' = -w0² x - c x' - q x'|x'| - k3 x³, coefficients per unit mass; for a pendulum
/// w0² sin x in place of w0² x.
template <Law law, std::size_t N>
class SlopedLaw {
 public:
  using Real = Dual<double, N>;
  static constexpr bool depends_on_velocity = true;
  static constexpr bool depends_on_time = false;

  /// `pendulum` counts where code is shared (each_set_of_terms); elsewhere the law's own does.
  SlopedLaw(const Oscillator<Real>& per_mass, bool pendulum) : law_(per_mass), pendulum_(pendulum) {}

  template <class Time>
  Real acceleration(const Time&, const Real& position, const Real& velocity) const {
    const double x = position.value, v = velocity.value;
    const bool pendulum = each_set_of_terms ? law.pendulum : pendulum_;
    const double pull = pendulum ? std::sin(x) : x;
    double by_x = -law_.stiffness.value * (pendulum ? std::cos(x) : 1);
    double by_v = -law_.damping.value, drag = 0, cube = 0;
    Real a(-law_.damping.value * v - law_.stiffness.value * pull);
    if constexpr (law.drag) {
      drag = v * std::abs(v);
      a.value -= law_.drag.value * drag;
      by_v -= 2 * law_.drag.value * std::abs(v);
    }
    if constexpr (law.cubic) {
      cube = x * x * x;
      a.value -= law_.cubic.value * cube;
      by_x -= 3 * law_.cubic.value * x * x;
    }
    for (std::size_t i = 0; i < N; ++i) {
      double sum = by_x * position.derivative[i] - pull * law_.stiffness.derivative[i];
      sum += by_v * velocity.derivative[i] - v * law_.damping.derivative[i];
      if constexpr (law.drag) sum -= drag * law_.drag.derivative[i];
      if constexpr (law.cubic) sum -= cube * law_.cubic.derivative[i];
      a.derivative[i] = sum;
    }
    return a;
  }

 private:
  Oscillator<Real> law_;
  bool pendulum_;
};

}  // namespace cromer
