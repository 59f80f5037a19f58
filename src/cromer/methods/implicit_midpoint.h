#pragma once

#include "cromer/base/dual.h"
#include "cromer/base/magnitude.h"
#include "cromer/methods/method.h"
#include "cromer/methods/newton.h"

namespace cromer::core {

/// v' = v + h a, x' = x + h (v + v')/2 with a = a(t + h/2, (x + x')/2, (v + v')/2): one equation, for a. The
/// one-stage Gauss method: it keeps the energy of the undamped linear law at any step.
struct ImplicitMidpoint {
  static constexpr MethodInfo info{
      .name = "implicit-midpoint",
      .order = 2,
      .error_order = 0,
      .evaluations = 0,
      .implicit = true,
      .symplectic = true,
      .reversible = true,
      .a_stable = true,
      .divisions = 2,
      .source = "K. Feng, Proc. 1984 Beijing Symp. Differential Geometry & Differential Equations, 42 (1985)",
  };

  NewtonOptions newton;

  /// The acceleration of the last step, as a guess, and the largest so far.
  template <class Real>
  struct Memory {
    Real acceleration;      // [m/s^2]
    Magnitude<Real> scale;  // [m/s^2]
  };

  template <class S, class Time, class Real>
  Memory<Real> start(const S& system, const Time& t, const State<Real>& y) const {
    const Real a = system.acceleration(t, y.x, y.v);
    return {a, magnitude(a)};
  }

  template <class S, class Time, class Real>
  Trial<Real> step(const S& system, const Time& t, const Time& h, const State<Real>& y,
                   Memory<Real>& memory) const {
    const auto middle_velocity = [&](const auto& a) { return y.v + h / 2 * a; };
    const auto residual = [&](const Unknown<Real>& a) {
      const Unknown<Real> v = middle_velocity(a);
      return a - system.acceleration(t + h / 2, y.x + h / 2 * v, v);
    };
    const auto solved = cromer::core::newton(residual, memory.acceleration,
                                             {memory.scale, acceleration_rounding(y, h)}, newton);
    const Real a = solved.root;
    memory = {a, larger(memory.scale, magnitude(a))};
    return {.y = {y.x + h * middle_velocity(a), y.v + h * a},
            .newton_iterations = solved.iterations,
            .converged = solved.converged};
  }
};

}  // namespace cromer::core
