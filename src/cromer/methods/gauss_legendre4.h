#pragma once

#include <array>

#include "cromer/base/dual.h"
#include "cromer/base/magnitude.h"
#include "cromer/methods/method.h"
#include "cromer/methods/newton.h"

namespace cromer::core {

/// The two-stage Gauss method: two equations, for the accelerations at the nodes t + (1/2 -+ sqrt(3)/6) h.
/// It keeps the energy of the undamped linear law at any step.
struct GaussLegendre4 {
  static constexpr MethodInfo info{
      .name = "gauss-legendre4",
      .order = 4,
      .error_order = 0,
      .evaluations = 0,
      .iteration_evaluations = 2,
      .implicit = true,
      .symplectic = true,
      .reversible = true,
      .a_stable = true,
      .divisions = 0,
      .source = "J. C. Butcher, Math. Comput. 18, 50 (1964)",
  };

  static constexpr double off = 0.28867513459481288225;  // sqrt(3)/6

  static constexpr std::array<double, 2> asked_at() { return {0.5 - off, 0.5 + off}; }

  NewtonOptions newton;

  /// The accelerations of the last step, as a guess, and the largest so far.
  template <class Real>
  struct Memory {
    std::array<Real, 2> accelerations;  // [m/s^2]
    Magnitude<Real> scale;              // [m/s^2]
  };

  template <class S, class Time, class Real>
  Memory<Real> start(const S& system, const Time& t, const State<Real>& y) const {
    const Real a = system.acceleration(t, y.x, y.v);
    return {{a, a}, magnitude(a)};
  }

  template <class S, class Time, class Real>
  Trial<Real> step(const S& system, const Time& t, const Time& h, const State<Real>& y,
                   Memory<Real>& memory) const {
    constexpr double near = 0.25 - off, far = 0.25 + off;
    // From slopes at the two nodes to the rise from the start to each node.
    const auto to_first = [&](const auto& k1, const auto& k2) { return h * (0.25 * k1 + near * k2); };
    const auto to_second = [&](const auto& k1, const auto& k2) { return h * (far * k1 + 0.25 * k2); };

    // Left to itself a compiler finds it too large to inline, and steps take half as long again.
    const auto residual = [&](const std::array<Unknown<Real, 2>, 2>& a) __attribute__((always_inline)) {
      const Unknown<Real, 2> v1 = y.v + to_first(a[0], a[1]), v2 = y.v + to_second(a[0], a[1]);
      const Unknown<Real, 2> x1 = y.x + to_first(v1, v2), x2 = y.x + to_second(v1, v2);
      return std::array<Unknown<Real, 2>, 2>{a[0] - system.acceleration(t + (0.5 - off) * h, x1, v1),
                                             a[1] - system.acceleration(t + (0.5 + off) * h, x2, v2)};
    };
    const auto solved = cromer::core::newton(residual, memory.accelerations,
                                             {memory.scale, acceleration_rounding(y, h)}, newton);
    const auto& [a1, a2] = solved.root;
    memory = {solved.root, larger(memory.scale, larger(magnitude(a1), magnitude(a2)))};
    const Real mean = y.v + 0.5 * (to_first(a1, a2) + to_second(a1, a2));
    return {.y = {y.x + h * mean, y.v + h / 2 * (a1 + a2)},
            .newton_iterations = solved.iterations,
            .converged = solved.converged};
  }
};

}  // namespace cromer::core
