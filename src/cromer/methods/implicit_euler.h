#pragma once

#include <limits>

#include "cromer/base/dual.h"
#include "cromer/base/magnitude.h"
#include "cromer/methods/method.h"
#include "cromer/methods/newton.h"

namespace cromer::core {

/// v' = v + h a(t + h, x', v'), x' = x + h v': the second put into the first leaves one equation, for v'.
/// Stable at any step, and damps what is not damped: decay rate about w^2 h/2.
struct ImplicitEuler {
  static constexpr MethodInfo info{
      .name = "implicit-euler",
      .order = 1,
      .error_order = 0,
      .evaluations = 0,
      .implicit = true,
      .symplectic = false,
      .a_stable = true,
      .divisions = 1,
      .source = "C. F. Curtiss & J. O. Hirschfelder, Proc. Natl. Acad. Sci. 38, 235 (1952)",
  };

  NewtonOptions newton;

  /// The rise of the velocity in the last step, as a guess for the next; and the largest velocity of the
  /// motion so far.
  template <class Real>
  struct Memory {
    Real rise;              // [m/s]
    Magnitude<Real> scale;  // [m/s]
  };

  template <class S, class Time, class Real>
  Memory<Real> start(const S&, const Time&, const State<Real>& y) const {
    return {Real(0), magnitude(y.v)};
  }

  template <class S, class Time, class Real>
  Trial<Real> step(const S& system, const Time& t, const Time& h, const State<Real>& y,
                   Memory<Real>& memory) const {
    const auto residual = [&](const Unknown<Real>& v) {
      return v - y.v - h * system.acceleration(t + h, y.x + h * v, v);
    };
    // A velocity that moves x by less than its last digit changes nothing.
    const Magnitude<Real> rounding = std::numeric_limits<double>::epsilon() / magnitude(h) * magnitude(y.x);
    const auto solved = cromer::core::newton(residual, y.v + memory.rise, {memory.scale, rounding}, newton);
    const Real v = solved.root;
    memory = {v - y.v, larger(memory.scale, magnitude(v))};
    return {.y = {y.x + h * v, v}, .newton_iterations = solved.iterations, .converged = solved.converged};
  }
};

}  // namespace cromer::core
