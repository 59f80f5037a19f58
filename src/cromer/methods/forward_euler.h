#pragma once

#include "cromer/methods/method.h"

namespace cromer::core {

/// Both updates from the old state. Unstable without damping: the energy grows by 1 + w^2 h^2 a step.
struct ForwardEuler {
  static constexpr MethodInfo info{
      .name = "forward-euler",
      .order = 1,
      .error_order = 0,
      .evaluations = 1,
      .implicit = false,
      .symplectic = false,
      .divisions = 1,
      .source = "L. Euler, Institutionum calculi integralis, vol. 1, 1768, section 650",
  };

  template <class Real>
  using Memory = NoMemory;

  template <class S, class Time, class Real>
  NoMemory start(const S&, const Time&, const State<Real>&) const {
    return {};
  }

  template <class S, class Time, class Real>
  Trial<Real> step(const S& system, const Time& t, const Time& h, const State<Real>& y, NoMemory&) const {
    return {.y = {y.x + h * y.v, y.v + h * system.acceleration(t, y.x, y.v)}};
  }
};

}  // namespace cromer::core
