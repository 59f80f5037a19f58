// One body, every method of the registry.
#include "cromer/methods/all.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"
#include "tests/support/every_method.h"

namespace cromer::core {
namespace CROMER_FILE {

using Oscillating = DrivenOscillator<double, Terms{.drive = true, .law = law_of("viscous")}>;
using Free = DrivenOscillator<double, Terms{}>;

const Oscillating damped_and_driven({1, 9, 0.4, 0, 0, 0}, {1.0, 2.0, 0.3});
const Free undamped({1, 9, 0, 0, 0, 0}, {});

INSTANTIATE_TEST_SUITE_P(Registry, EveryMethod, testing::ValuesIn(method_names), name_of_test);

TEST_P(EveryMethod, HasTheDeclaredOrder) {
  const State<double> start{0.5, -0.3};
  const double until = 2;
  const State<double> exact = damped_and_driven.propagate(0, until, start);
  const auto error = [&](int steps) {
    const State<double> y = end(damped_and_driven, start, until, until / steps);
    return std::hypot(y.x - exact.x, (y.v - exact.v) / 3);
  };
  if (info().order == 0) {
    EXPECT_LT(error(7), 1e-15);
    return;
  }
  // The slope over a factor of four, with step sizes at which neither higher orders nor rounding show.
  const int steps = info().order >= 4 ? 100 : 4000;
  const double order = std::log2(error(steps) / error(4 * steps)) / 2;
  EXPECT_NEAR(order, info().order, 0.1);
}

TEST_P(EveryMethod, HasTheDeclaredOrderWithEveryTerm) {
  if (info().order == 0) GTEST_SKIP() << "has its closed form only";
  Oscillator<double> law{.stiffness = 9};
  for_each_term([&]<class T>() {
    if constexpr (smooth_terms.without(law_with<Spring>).template has<T>())
      law.*T::template members<double>[0] = 0.8;
  });
  const DrivenOscillator<double, Terms{.drive = true, .law = any_terms}> system(law, {1.0, 2.0, 0.3});
  // Until before position or velocity vanish, where |x| and |v| have corners.
  const State<double> start{0.9, -0.3};
  const double until = 0.4;
  State<double> exact = start;
  auto memory = DormandPrince{}.start(system, 0.0, start);
  for (int n = 0; n < 500; ++n) {
    exact = DormandPrince{}.step(system, n * until / 500, until / 500, exact, memory).y;
    ASSERT_GT(exact.x, 0);
    ASSERT_LT(exact.v, 0);
  }
  const auto error = [&](int steps) {
    const State<double> y = end(system, start, until, until / steps);
    return std::hypot(y.x - exact.x, (y.v - exact.v) / 3);
  };
  const int steps = info().order >= 4 ? 20 : 800;
  EXPECT_NEAR(std::log2(error(steps) / error(4 * steps)) / 2, info().order, 0.15);
}

TEST_P(EveryMethod, KeepsAreaIfSymplectic) {
  // The Jacobian of one step, by duals; for the Duffing law, where that is more than a property of a matrix.
  using D = Dual<double, 2>;
  const State<D> start{D::variable(0.7, 0), D::variable(-0.2, 1)};
  const auto area = [](const State<D>& y) {
    return y.x.derivative[0] * y.v.derivative[1] - y.x.derivative[1] * y.v.derivative[0];
  };
  for (const double h : {0.01, 0.1, 0.3}) {
    const DrivenOscillator<D, Terms{.law = law_of("cubic")}> hardening({1.0, 9.0, 0.0, 0.0, 0.0, 4.0}, {});
    const DrivenOscillator<D, Terms{}> linear({1.0, 9.0, 0.0, 0.0, 0.0, 0.0}, {});
    const double off =
        std::abs(area(GetParam() == "exact" ? end(linear, start, h, h) : end(hardening, start, h, h)) - 1);
    EXPECT_EQ(off < 1e-13, info().symplectic) << h << ": " << off;
  }
}

TEST_P(EveryMethod, AStepBackUndoesAStepIfReversible) {
  const State<double> start{0.5, -0.3};
  for (const double h : {0.1, 0.3}) {
    const double off = with_method([&](const auto& method) {
      auto there = method.start(damped_and_driven, 1.0, start);
      const State<double> y = method.step(damped_and_driven, 1.0, h, start, there).y;
      auto back = method.start(damped_and_driven, 1.0 + h, y);
      const State<double> again = method.step(damped_and_driven, 1.0 + h, -h, y, back).y;
      return std::hypot(again.x - start.x, again.v - start.v);
    });
    EXPECT_EQ(off < 1e-13, info().reversible) << h << ": " << off;
  }
}

/// x'' given as a function of time alone, so that x = 1 + t + ... + t^degree/degree!.
struct Polynomial {
  static constexpr bool depends_on_velocity = false;
  int degree;

  double at(double t, int from) const {
    double sum = 0, term = 1;
    for (int i = from; i <= degree; ++i) {
      sum += term;
      term *= t / (i - from + 1);
    }
    return sum;
  }
  template <class T>
  T acceleration(double t, const T&, const T&) const {
    return T(at(t, 2));
  }
};

TEST_P(EveryMethod, IsExactOnPolynomialsOfItsOrderAndNotBeyond) {
  if (info().order == 0) GTEST_SKIP() << "has its closed form only";
  const double h = 0.7;
  const auto error = [&](int degree) {
    const Polynomial p{degree};
    const State<double> y = end(p, {p.at(0, 0), p.at(0, 1)}, 3 * h, h);
    return std::hypot(y.x - p.at(3 * h, 0), y.v - p.at(3 * h, 1));
  };
  for (int degree = 1; degree <= info().order; ++degree) EXPECT_LT(error(degree), 2e-14) << degree;
  EXPECT_GT(error(info().order + 1), 1e-6);
}

TEST_P(EveryMethod, BoundsTheEnergyIfSymplectic) {
  const double h = 0.02;
  double most = 0;
  with_method([&](const auto& method) {
    const auto watch_energy = [&](double, const State<double>& y) {
      most = std::max(most, std::abs((y.v * y.v + 9 * y.x * y.x) / 9 - 1));
    };
    solve(undamped, method, {0, 2000}, State<double>{1, 0}, h, watch_energy);
    return 0;
  });
  const bool bounded = most < 3 * h;
  EXPECT_TRUE(bounded || !info().symplectic) << most;
  // The test can tell: the first-order methods that are not symplectic gain or lose everything.
  if (!info().symplectic && info().order == 1) {
    EXPECT_GT(most, 0.9);
  }
}

TEST_P(EveryMethod, CountsNewtonIterationsIfImplicit) {
  if (info().error_order > 0) GTEST_SKIP() << "takes as many steps as it needs";
  with_method([&](const auto& method) {
    const auto counts =
        solve(damped_and_driven, method, {0, 1}, State<double>{1, 0}, 0.01, KeepNone{}).counts;
    EXPECT_EQ(counts.accepted, 100);
    if (info().implicit) {
      EXPECT_GE(counts.newton_iterations, 100);
      EXPECT_LE(counts.newton_iterations, 300) << "a linear equation takes two, seldom three";
    }
    EXPECT_EQ(counts.evaluations,
              100 * info().evaluations + counts.newton_iterations * info().iteration_evaluations);
    return 0;
  });
}

TEST_P(EveryMethod, RestStaysAtRest) {
  const State<double> y = end(undamped, {0, 0}, 1, 0.01);
  EXPECT_EQ(y, (State<double>{0, 0}));
}

TEST_P(EveryMethod, RestsInAnEquilibriumUnderConstantForce) {
  // Rounding is all that moves it; implicit methods must not take that for no convergence.
  const DrivenOscillator<double, Terms{.drive = true, .law = law_of("viscous")}> pushed({1, 7, 0.1, 0, 0, 0},
                                                                                        {0.3, 0, 0});
  for (const double h : {1e-5, 0.01, 0.2}) {
    const State<double> y = end(pushed, {0.3 / 7, 0}, 100 * h, h);
    EXPECT_NEAR(y.x, 0.3 / 7, 1e-15) << h;
  }
}

TEST_P(EveryMethod, CarriesDerivatives) {
  // d x(1) / d (stiffness, x0) by duals, against differences.
  using D = Dual<double, 2>;
  const auto run = [&](double k, double x0) {
    const Oscillating system({1, k, 0.4, 0, 0, 0}, {1.0, 2.0, 0.3});
    return end(system, {x0, -0.3}, 1, 0.01).x;
  };
  const DrivenOscillator<D, Terms{.drive = true, .law = law_of("viscous")}> system(
      {1.0, D::variable(9, 0), 0.4, 0.0, 0.0, 0.0}, {1.0, 2.0, 0.3});
  const State<D> y = end(system, State<D>{D::variable(0.5, 1), -0.3}, 1, 0.01);
  EXPECT_DOUBLE_EQ(y.x.value, run(9, 0.5));
  EXPECT_NEAR(y.x.derivative[0], (run(9.001, 0.5) - run(8.999, 0.5)) / 0.002, 1e-8);
  EXPECT_NEAR(y.x.derivative[1], (run(9, 0.501) - run(9, 0.499)) / 0.002, 1e-9);
}

/// The same system without its table.
struct Untabulated {
  template <class T>
  T acceleration(double t, const T& x, const T& v) const {
    return damped_and_driven.acceleration(t, x, v);
  }
  State<double> propagate(double t0, double t, State<double> y) const {
    return damped_and_driven.propagate(t0, t, y);
  }
};

TEST_P(EveryMethod, TabulatedDriveIsTheDrive) {
  // What solve does by itself must not be seen.
  // 1000 s are 100000 steps; not a whole number of blocks, and a shorter last step.
  const State<double> with_table = end(damped_and_driven, {1, 0}, 1000.0337, 0.01);
  const State<double> without = end(Untabulated{}, {1, 0}, 1000.0337, 0.01);
  EXPECT_NEAR(with_table.x, without.x, 1e-13);
  EXPECT_NEAR(with_table.v, without.v, 1e-13);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
