#pragma once

#include "cromer/base/dual.h"
#include "cromer/base/magnitude.h"
#include "cromer/methods/method.h"
#include "cromer/methods/newton.h"

namespace cromer::core {

/// x' = x + h v + h^2 ((1/2 - beta) a + beta a'), v' = v + h ((1 - gamma) a + gamma a'), with a' = a(t + h,
/// x', v'): one equation, for a'. beta 1/4 is the average acceleration (trapezoidal rule), 1/6 the linear
/// acceleration, 0 the central difference; gamma other than 1/2 makes it first order, damping above, growing
/// below.
struct Newmark {
  static constexpr MethodInfo info{
      .name = "newmark",
      .order = 2,
      .error_order = 0,
      .evaluations = 0,
      .implicit = true,
      .symplectic = false,
      .reversible = true,
      .a_stable = true,
      .divisions = 1,
      .source = "N. M. Newmark, J. Eng. Mech. Div. ASCE 85 (EM3), 67 (1959)",
  };

  NewtonOptions newton;
  double beta = 0.25;  ///< 0 to 1
  double gamma = 0.5;  ///< 0 to 1

  /// The acceleration at the state, and the largest of the motion so far.
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
    const Real& a = memory.acceleration;
    const State<Real> predicted{y.x + h * (y.v + h * ((0.5 - beta) * a)), y.v + h * ((1 - gamma) * a)};
    const auto position = [&](const auto& next) { return predicted.x + h * h * (beta * next); };
    const auto velocity = [&](const auto& next) { return predicted.v + h * (gamma * next); };
    const auto residual = [&](const Unknown<Real>& next) {
      return next - system.acceleration(t + h, position(next), velocity(next));
    };
    const auto solved =
        cromer::core::newton(residual, a, {memory.scale, acceleration_rounding(y, h)}, newton);
    memory.acceleration = solved.root;
    memory.scale = larger(memory.scale, magnitude(solved.root));
    return {.y = {position(solved.root), velocity(solved.root)},
            .newton_iterations = solved.iterations,
            .converged = solved.converged};
  }
};

}  // namespace cromer::core
