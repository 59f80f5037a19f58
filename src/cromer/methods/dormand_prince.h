#pragma once

#include <array>

#include "cromer/base/dual.h"
#include "cromer/methods/method.h"

namespace cromer::core {

/// DOPRI5: fifth order with an embedded fourth-order estimate, which chooses the steps; the last stage of a
/// step is the first of the next. Dense output of fourth order by L. F. Shampine, Math. Comput. 46, 135
/// (1986), in the form of Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
/// section II.6.
struct DormandPrince {
  static constexpr MethodInfo info{
      .name = "dormand-prince",
      .order = 5,
      .error_order = 4,
      .evaluations = 6,
      .implicit = false,
      .symplectic = false,
      .divisions = 0,
      .source = "J. R. Dormand & P. J. Prince, J. Comput. Appl. Math. 6, 19 (1980)",
  };

  /// Where in a step it asks for accelerations.
  static constexpr std::array nodes{1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0};

  /// The last step: its ends, the accelerations there, and the slopes between them that dense output needs.
  template <class Real>
  struct Memory {
    State<Real> from, to;
    Real acceleration_from, acceleration_to;  // [m/s^2]
    std::array<State<Real>, 4> slopes;        // third to sixth [m/s], [m/s^2]
    double step;                              // [s]
  };

  template <class S, class Time, class Real>
  Memory<Real> start(const S& system, const Time& t, const State<Real>& y) const {
    const Real a = system.acceleration(t, y.x, y.v);
    return {y, y, a, a, {}, 0.0};
  }

  template <class S, class Time, class Real>
  Trial<Real> step(const S& system, const Time& t, const Time& h, const State<Real>& y,
                   Memory<Real>& memory) const {
    // Slopes k_i = (v_i, a_i) at t + c_i h; the weights of the last are those of the solution. In each sum
    // the newest slope comes last, alone: from it to the next is the longest way through a step.
    const Real v1 = y.v, a1 = memory.acceleration_to;
    const auto second = [&](const Real& u, const Real& k1) { return u + h * (1.0 / 5) * k1; };
    const Real v2 = second(y.v, a1);
    const Real a2 = system.acceleration(t + 1.0 / 5 * h, second(y.x, v1), v2);
    const auto third = [&](const Real& u, const Real& k1, const Real& k2) {
      return (u + h * (3.0 / 40 * k1)) + h * (9.0 / 40) * k2;
    };
    const Real v3 = third(y.v, a1, a2);
    const Real a3 = system.acceleration(t + 3.0 / 10 * h, third(y.x, v1, v2), v3);
    const auto fourth = [&](const Real& u, const Real& k1, const Real& k2, const Real& k3) {
      return (u + h * (44.0 / 45 * k1 - 56.0 / 15 * k2)) + h * (32.0 / 9) * k3;
    };
    const Real v4 = fourth(y.v, a1, a2, a3);
    const Real a4 = system.acceleration(t + 4.0 / 5 * h, fourth(y.x, v1, v2, v3), v4);
    const auto fifth = [&](const Real& u, const Real& k1, const Real& k2, const Real& k3, const Real& k4) {
      return (u + h * (19372.0 / 6561 * k1 - 25360.0 / 2187 * k2 + 64448.0 / 6561 * k3)) -
             h * (212.0 / 729) * k4;
    };
    const Real v5 = fifth(y.v, a1, a2, a3, a4);
    const Real a5 = system.acceleration(t + 8.0 / 9 * h, fifth(y.x, v1, v2, v3, v4), v5);
    const auto sixth = [&](const Real& u, const Real& k1, const Real& k2, const Real& k3, const Real& k4,
                           const Real& k5) {
      return (u + h * (9017.0 / 3168 * k1 - 355.0 / 33 * k2 + 46732.0 / 5247 * k3 + 49.0 / 176 * k4)) -
             h * (5103.0 / 18656) * k5;
    };
    const Real v6 = sixth(y.v, a1, a2, a3, a4, a5);
    const Real a6 = system.acceleration(t + h, sixth(y.x, v1, v2, v3, v4, v5), v6);
    const auto solution = [&](const Real& u, const Real& k1, const Real& k3, const Real& k4, const Real& k5,
                              const Real& k6) {
      return u + (h * (35.0 / 384 * k1 + 500.0 / 1113 * k3 + 125.0 / 192 * k4 - 2187.0 / 6784 * k5) +
                  h * (11.0 / 84) * k6);
    };
    const State<Real> to{solution(y.x, v1, v3, v4, v5, v6), solution(y.v, a1, a3, a4, a5, a6)};
    const Real v7 = to.v, a7 = system.acceleration(t + h, to.x, to.v);

    // Fifth order less fourth.
    const auto off = [](const Real& k1, const Real& k3, const Real& k4, const Real& k5, const Real& k6,
                        const Real& k7) {
      return 71.0 / 57600 * k1 - 71.0 / 16695 * k3 + 71.0 / 1920 * k4 - 17253.0 / 339200 * k5 +
             22.0 / 525 * k6 - 1.0 / 40 * k7;
    };
    memory = {y, to, a1, a7, {{{v3, a3}, {v4, a4}, {v5, a5}, {v6, a6}}}, value_of(h)};
    return {.y = to, .error = {h * off(v1, v3, v4, v5, v6, v7), h * off(a1, a3, a4, a5, a6, a7)}};
  }

  /// The last step as a function of the fraction theta of it, from 0 to 1.
  template <class Real>
  auto dense_output(const Memory<Real>& memory) const {
    const auto& [from, to, a_from, a_to, k, length] = memory;
    const double h = length;  // lambdas may not take it from a binding
    // What the interpolant adds to the cubic through the ends.
    const auto quartic = [&](const Real& k1, const Real& k3, const Real& k4, const Real& k5, const Real& k6,
                             const Real& k7) {
      return -12715105075.0 / 11282082432.0 * k1 + 87487479700.0 / 32700410799.0 * k3 -
             10690763975.0 / 1880347072.0 * k4 + 701980252875.0 / 199316789632.0 * k5 -
             1453857185.0 / 822651844.0 * k6 + 69997945.0 / 29380423.0 * k7;
    };
    struct Component {
      Real from, rise, bend, twist, quartic;
      Real operator()(double theta) const {
        return from + theta * (rise + (1.0 - theta) * (bend + theta * (twist + (1.0 - theta) * quartic)));
      }
    };
    const auto component = [&](const Real& start, const Real& end, const Real& slope_from,
                               const Real& slope_to, const Real& fourth) -> Component {
      const Real rise = end - start, bend = h * slope_from - rise;
      return {start, rise, bend, rise - h * slope_to - bend, h * fourth};
    };
    return [x = component(from.x, to.x, from.v, to.v, quartic(from.v, k[0].x, k[1].x, k[2].x, k[3].x, to.v)),
            v = component(from.v, to.v, a_from, a_to, quartic(a_from, k[0].v, k[1].v, k[2].v, k[3].v, a_to))](
               double theta) {
      return State<Real>{x(theta), v(theta)};
    };
  }
};

}  // namespace cromer::core
