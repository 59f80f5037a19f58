#pragma once

#include "cromer/base/dual.h"
#include "cromer/methods/method.h"

namespace cromer {

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

  /// The last step: its ends, the accelerations there, and what the interpolant adds to the cubic through
  /// them.
  template <class Real>
  struct Memory {
    State<Real> from, to;
    Real acceleration_from, acceleration_to;  // [m/s^2]
    State<Real> quartic;                      // [m], [m/s]
    double step;                              // [s]
  };

  template <class S, class Time, class Real>
  Memory<Real> start(const S& system, const Time& t, const State<Real>& y) const {
    const Real a = system.acceleration(t, y.x, y.v);
    return {y, y, a, a, {Real(0), Real(0)}, 0.0};
  }

  template <class S, class Time, class Real>
  Trial<Real> step(const S& system, const Time& t, const Time& h, const State<Real>& y,
                   Memory<Real>& memory) const {
    // Slopes k_i = (v_i, a_i) at t + c_i h; the weights of the last are those of the solution.
    const Real v1 = y.v, a1 = memory.acceleration_to;
    const Real v2 = y.v + h * (1.0 / 5 * a1);
    const Real a2 = system.acceleration(t + 1.0 / 5 * h, Real(y.x + h * (1.0 / 5 * v1)), v2);
    const auto sum3 = [](const Real& k1, const Real& k2) { return 3.0 / 40 * k1 + 9.0 / 40 * k2; };
    const Real v3 = y.v + h * sum3(a1, a2);
    const Real a3 = system.acceleration(t + 3.0 / 10 * h, Real(y.x + h * sum3(v1, v2)), v3);
    const auto sum4 = [](const Real& k1, const Real& k2, const Real& k3) {
      return 44.0 / 45 * k1 - 56.0 / 15 * k2 + 32.0 / 9 * k3;
    };
    const Real v4 = y.v + h * sum4(a1, a2, a3);
    const Real a4 = system.acceleration(t + 4.0 / 5 * h, Real(y.x + h * sum4(v1, v2, v3)), v4);
    const auto sum5 = [](const Real& k1, const Real& k2, const Real& k3, const Real& k4) {
      return 19372.0 / 6561 * k1 - 25360.0 / 2187 * k2 + 64448.0 / 6561 * k3 - 212.0 / 729 * k4;
    };
    const Real v5 = y.v + h * sum5(a1, a2, a3, a4);
    const Real a5 = system.acceleration(t + 8.0 / 9 * h, Real(y.x + h * sum5(v1, v2, v3, v4)), v5);
    const auto sum6 = [](const Real& k1, const Real& k2, const Real& k3, const Real& k4, const Real& k5) {
      return 9017.0 / 3168 * k1 - 355.0 / 33 * k2 + 46732.0 / 5247 * k3 + 49.0 / 176 * k4 -
             5103.0 / 18656 * k5;
    };
    const Real v6 = y.v + h * sum6(a1, a2, a3, a4, a5);
    const Real a6 = system.acceleration(t + h, Real(y.x + h * sum6(v1, v2, v3, v4, v5)), v6);
    const auto sum7 = [](const Real& k1, const Real& k3, const Real& k4, const Real& k5, const Real& k6) {
      return 35.0 / 384 * k1 + 500.0 / 1113 * k3 + 125.0 / 192 * k4 - 2187.0 / 6784 * k5 + 11.0 / 84 * k6;
    };
    const State<Real> to{y.x + h * sum7(v1, v3, v4, v5, v6), y.v + h * sum7(a1, a3, a4, a5, a6)};
    const Real v7 = to.v, a7 = system.acceleration(t + h, to.x, to.v);

    // Fifth order less fourth.
    const auto off = [](const Real& k1, const Real& k3, const Real& k4, const Real& k5, const Real& k6,
                        const Real& k7) {
      return 71.0 / 57600 * k1 - 71.0 / 16695 * k3 + 71.0 / 1920 * k4 - 17253.0 / 339200 * k5 +
             22.0 / 525 * k6 - 1.0 / 40 * k7;
    };
    const auto quartic = [](const Real& k1, const Real& k3, const Real& k4, const Real& k5, const Real& k6,
                            const Real& k7) {
      return -12715105075.0 / 11282082432.0 * k1 + 87487479700.0 / 32700410799.0 * k3 -
             10690763975.0 / 1880347072.0 * k4 + 701980252875.0 / 199316789632.0 * k5 -
             1453857185.0 / 822651844.0 * k6 + 69997945.0 / 29380423.0 * k7;
    };
    memory = {
        y,          to, a1, a7, {h * quartic(v1, v3, v4, v5, v6, v7), h * quartic(a1, a3, a4, a5, a6, a7)},
        value_of(h)};
    return {.y = to, .error = {h * off(v1, v3, v4, v5, v6, v7), h * off(a1, a3, a4, a5, a6, a7)}};
  }

  /// The state at the fraction theta of the last step, from 0 to 1.
  template <class Real, class Time>
  State<Real> interpolate(const Memory<Real>& memory, const Time& theta) const {
    const auto at = [&](const Real& from, const Real& to, const Real& slope_from, const Real& slope_to,
                        const Real& quartic) {
      const Real rise = to - from;
      const Real bend = memory.step * slope_from - rise;
      const Real twist = rise - memory.step * slope_to - bend;
      return from + theta * (rise + (1.0 - theta) * (bend + theta * (twist + (1.0 - theta) * quartic)));
    };
    const auto& [from, to, a_from, a_to, quartic, length] = memory;
    return {at(from.x, to.x, from.v, to.v, quartic.x), at(from.v, to.v, a_from, a_to, quartic.v)};
  }
};

}  // namespace cromer
