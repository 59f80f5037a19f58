// A pendulum's restoring force beside the other terms of the law.
#pragma once

#include "cromer/model/force_terms.h"

namespace cromer {

/// x'' = f - w0² sin x, x an angle [rad], with f the acceleration of `Rest`: the law's other terms.
template <class Rest, class Real>
class Pendulum {
 public:
  static constexpr bool depends_on_velocity = Rest::depends_on_velocity;
  static constexpr bool depends_on_time = Rest::depends_on_time;

  /// stiffness: w0² [1/s²], of small swings.
  Pendulum(const Rest& rest, const Real& stiffness) : rest_(rest), stiffness_(stiffness) {}

  /// [rad/s²]. T is Real, or a Dual over it.
  template <class Time, class T>
  T acceleration(const Time& t, const T& x, const T& v) const {
    return rest_.acceleration(t, x, v) - pendulum_term(stiffness_, x);
  }

 private:
  Rest rest_;
  Real stiffness_;
};

}  // namespace cromer
