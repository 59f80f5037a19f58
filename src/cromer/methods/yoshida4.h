#pragma once

#include <array>

#include "cromer/methods/method.h"
#include "cromer/methods/newton.h"
#include "cromer/methods/verlet.h"

namespace cromer::core {

/// Three steps of velocity Verlet, the middle one backwards: their third-order errors cancel.
struct Yoshida4 {
  static constexpr MethodInfo info{
      .name = "yoshida4",
      .order = 4,
      .error_order = 0,
      .evaluations = 3 * Verlet::info.evaluations,
      .implicit = false,
      .symplectic = true,
      .reversible = true,
      .divisions = 0,
      .source = "H. Yoshida, Phys. Lett. A 150, 262 (1990)",
  };

  static constexpr double outer = 1.3512071919596576340;  // 1/(2 - 2^(1/3))
  static constexpr double inner = 1 - 2 * outer;

  /// The ends of its three steps.
  static constexpr std::array<double, 3> asked_at() { return {outer, 1 - outer, 1}; }

  NewtonOptions newton;

  template <class Real>
  using Memory = Verlet::Memory<Real>;

  template <class S, class Time, class Real>
  Memory<Real> start(const S& system, const Time& t, const State<Real>& y) const {
    return Verlet{newton}.start(system, t, y);
  }

  template <class S, class Time, class Real>
  Trial<Real> step(const S& system, const Time& t, const Time& h, const State<Real>& y,
                   Memory<Real>& memory) const {
    const Verlet verlet{newton};
    const Trial<Real> first = verlet.step(system, t, outer * h, y, memory);
    const Trial<Real> second = verlet.step(system, t + outer * h, inner * h, first.y, memory);
    const Trial<Real> third = verlet.step(system, t + (1 - outer) * h, outer * h, second.y, memory);
    return {.y = third.y,
            .newton_iterations = first.newton_iterations + second.newton_iterations + third.newton_iterations,
            .converged = first.converged && second.converged && third.converged};
  }
};

}  // namespace cromer::core
