#pragma once

#include <array>

#include "cromer/base/dual.h"
#include "cromer/base/magnitude.h"
#include "cromer/methods/method.h"
#include "cromer/methods/newton.h"

namespace cromer::core {

/// Newmark's updates with an acceleration of the method's own: (1 - alpha_m) a' + alpha_m a is the law's
/// acceleration at the time and state alpha_f of the way back from the step's end. Second order, with the
/// spectral radius rho_inf for steps far beyond the period: it damps what the step cannot resolve and spares
/// the rest.
struct GeneralizedAlpha {
  static constexpr MethodInfo info{
      .name = "generalized-alpha",
      .order = 2,
      .error_order = 0,
      .evaluations = 0,
      .implicit = true,
      .symplectic = false,
      .a_stable = true,
      .divisions = 0,
      .source = "J. Chung & G. M. Hulbert, J. Appl. Mech. 60, 371 (1993)",
  };

  NewtonOptions newton;
  double rho_inf = 0.8;  ///< 0 to 1

  constexpr std::array<double, 1> asked_at() const { return {1 / (1 + rho_inf)}; }

  /// The method's own acceleration, and the largest so far. Computed from the state instead, it would make
  /// the method first order.
  template <class Real>
  struct Memory {
    Real acceleration;      // [m/s^2]
    Magnitude<Real> scale;  // [m/s^2]
  };

  template <class Real>
  Real& carried(Memory<Real>& memory) const {
    return memory.acceleration;
  }

  template <class S, class Time, class Real>
  Memory<Real> start(const S& system, const Time& t, const State<Real>& y) const {
    const Real a = system.acceleration(t, y.x, y.v);
    return {a, magnitude(a)};
  }

  template <class S, class Time, class Real>
  Trial<Real> step(const S& system, const Time& t, const Time& h, const State<Real>& y,
                   Memory<Real>& memory) const {
    const double alpha_m = (2 * rho_inf - 1) / (1 + rho_inf), alpha_f = rho_inf / (1 + rho_inf);
    const double gamma = 0.5 - alpha_m + alpha_f, beta = 1 / ((1 + rho_inf) * (1 + rho_inf));
    const Real& a = memory.acceleration;
    const State<Real> predicted{y.x + h * (y.v + h * ((0.5 - beta) * a)), y.v + h * ((1 - gamma) * a)};
    const auto position = [&](const auto& next) { return predicted.x + h * h * (beta * next); };
    const auto velocity = [&](const auto& next) { return predicted.v + h * (gamma * next); };
    const auto residual = [&](const Unknown<Real>& next) {
      return (1 - alpha_m) * next + alpha_m * a -
             system.acceleration(t + (1 - alpha_f) * h, (1 - alpha_f) * position(next) + alpha_f * y.x,
                                 (1 - alpha_f) * velocity(next) + alpha_f * y.v);
    };
    const auto solved =
        cromer::core::newton(residual, a, {memory.scale, acceleration_rounding(y, h)}, newton);
    memory = {solved.root, larger(memory.scale, magnitude(solved.root))};
    return {.y = {position(solved.root), velocity(solved.root)},
            .newton_iterations = solved.iterations,
            .converged = solved.converged};
  }
};

}  // namespace cromer::core
