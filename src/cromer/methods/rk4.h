#pragma once

#include "cromer/methods/method.h"

namespace cromer::core {

/// The classical fourth-order method.
struct Rk4 {
  static constexpr MethodInfo info{
      .name = "rk4",
      .order = 4,
      .error_order = 0,
      .evaluations = 4,
      .implicit = false,
      .symplectic = false,
      .divisions = 2,
      .source = "W. Kutta, Z. Math. Phys. 46, 435 (1901)",
  };

  template <class Real>
  using Memory = NoMemory;

  template <class S, class Time, class Real>
  NoMemory start(const S&, const Time&, const State<Real>&) const {
    return {};
  }

  template <class S, class Time, class Real>
  Trial<Real> step(const S& system, const Time& t, const Time& h, const State<Real>& y, NoMemory&) const {
    const auto slope = [&](const Time& at, const State<Real>& u) {
      return State<Real>{u.v, system.acceleration(at, u.x, u.v)};
    };
    const auto moved = [&](const Time& by, const State<Real>& k) {
      return State<Real>{y.x + by * k.x, y.v + by * k.v};
    };
    const State<Real> k1 = slope(t, y);
    const State<Real> k2 = slope(t + h / 2, moved(h / 2, k1));
    const State<Real> k3 = slope(t + h / 2, moved(h / 2, k2));
    const State<Real> k4 = slope(t + h, moved(h, k3));
    const auto mean = [&](const Real& a, const Real& b, const Real& c, const Real& d) {
      return h / 6 * (a + 2.0 * (b + c) + d);
    };
    return {.y = {y.x + mean(k1.x, k2.x, k3.x, k4.x), y.v + mean(k1.v, k2.v, k3.v, k4.v)}};
  }
};

}  // namespace cromer::core
