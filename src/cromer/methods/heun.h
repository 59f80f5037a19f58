#pragma once

#include "cromer/methods/method.h"

namespace cromer::core {

/// The mean of the slopes at the old state and at forward Euler's new one. Undamped, the energy grows by
/// (w h)^4/4 a step.
struct Heun {
  static constexpr MethodInfo info{
      .name = "heun",
      .order = 2,
      .error_order = 0,
      .evaluations = 2,
      .implicit = false,
      .symplectic = false,
      .divisions = 1,
      .source = "K. Heun, Z. Math. Phys. 45, 23 (1900)",
  };

  template <class Real>
  using Memory = NoMemory;

  template <class S, class Time, class Real>
  NoMemory start(const S&, const Time&, const State<Real>&) const {
    return {};
  }

  template <class S, class Time, class Real>
  Trial<Real> step(const S& system, const Time& t, const Time& h, const State<Real>& y, NoMemory&) const {
    const Real a = system.acceleration(t, y.x, y.v);
    const State<Real> end{y.x + h * y.v, y.v + h * a};
    return {.y = {y.x + h / 2 * (y.v + end.v), y.v + h / 2 * (a + system.acceleration(t + h, end.x, end.v))}};
  }
};

}  // namespace cromer::core
