#pragma once

#include <utility>

#include "cromer/base/coupled.h"
#include "cromer/methods/method.h"

namespace cromer::core {

/// The position moves with the new velocity. That makes it symplectic: undamped, the energy swings by about w
/// h/2 but never drifts.
struct EulerCromer {
  static constexpr MethodInfo info{
      .name = "euler-cromer",
      .order = 1,
      .error_order = 0,
      .evaluations = 1,
      .implicit = false,
      .symplectic = true,
      .divisions = 1,
      .source = "A. Cromer, Am. J. Phys. 49, 455 (1981)",
  };

  template <class Real>
  using Memory = NoMemory;

  template <class S, class Time, class Real>
  NoMemory start(const S&, const Time&, const State<Real>&) const {
    return {};
  }

  template <class S, class Time, class Real>
  Trial<Real> step(const S& system, const Time& t, const Time& h, const State<Real>& y, NoMemory&) const {
    Real v = y.v + h * system.acceleration(t, y.x, y.v);
    // An inner state moves with the new velocity too.
    if constexpr (is_coupled<Real>) v.second = y.v.second + h * system.rate(v.first, y.v.second);
    Real x = y.x + h * v;
    return {.y = {std::move(x), std::move(v)}};
  }
};

}  // namespace cromer::core
