#pragma once

#include <limits>

#include "cromer/base/dual.h"
#include "cromer/base/magnitude.h"
#include "cromer/methods/method.h"
#include "cromer/methods/newton.h"

namespace cromer::core {

/// Velocity Verlet: x' = x + h v + h^2/2 a, v' = v + h/2 (a + a(t + h, x', v')). Where the force depends on
/// the velocity the second is an equation for v', solved by Newton's iteration.
struct Verlet {
  static constexpr MethodInfo info{
      .name = "verlet",
      .order = 2,
      .error_order = 0,
      .evaluations = 1,
      .implicit = false,
      .symplectic = true,
      .reversible = true,
      .divisions = 1,
      .source = "W. C. Swope et al., J. Chem. Phys. 76, 637 (1982)",
  };

  NewtonOptions newton;

  /// The acceleration at the state, and the largest velocity of the motion so far.
  template <class Real>
  struct Memory {
    Real acceleration;      // [m/s^2]
    Magnitude<Real> scale;  // [m/s]
  };

  template <class S, class Time, class Real>
  Memory<Real> start(const S& system, const Time& t, const State<Real>& y) const {
    return {system.acceleration(t, y.x, y.v), magnitude(y.v)};
  }

  template <class S, class Time, class Real>
  Trial<Real> step(const S& system, const Time& t, const Time& h, const State<Real>& y,
                   Memory<Real>& memory) const {
    const Real a = memory.acceleration;
    const Real x = y.x + h * (y.v + h / 2 * a);
    if (!depends_on_velocity(system)) {
      memory.acceleration = system.acceleration(t + h, x, y.v);
      return {.y = {x, y.v + h / 2 * (a + memory.acceleration)}};
    }
    if constexpr (depends_on_velocity<S>()) {
      const auto residual = [&](const Unknown<Real>& v) {
        return v - y.v - h / 2 * (a + system.acceleration(t + h, Unknown<Real>(x), v));
      };
      // A velocity that moves x by less than its last digit changes nothing.
      const Magnitude<Real> rounding =
          std::numeric_limits<double>::epsilon() * (magnitude(y.x) / magnitude(h));
      const auto solved = cromer::core::newton(residual, y.v + h * a, {memory.scale, rounding}, newton);
      const Real v = solved.root;
      memory.acceleration = system.acceleration(t + h, x, v);
      memory.scale = larger(memory.scale, magnitude(v));
      return {.y = {x, v}, .newton_iterations = solved.iterations, .converged = solved.converged};
    }
    return {};
  }
};

}  // namespace cromer::core
