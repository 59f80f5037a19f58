// A force with memory, by every method of the registry.
#include "cromer/model/hysteretic_oscillator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cromer/methods/all.h"
#include "cromer/model/harmonic_force.h"
#include "cromer/run/solve.h"
#include "tests/support/every_method.h"

namespace cromer::core {
namespace CROMER_FILE {

using System = HystereticOscillator<HarmonicForce<double>>;
using Both = State<Coupled<double>>;

Oscillator<double> bouc_wen(double exponent) {
  return {.mass = 1,
          .stiffness = 9,
          .damping = 0.1,
          .hysteresis_stiffness = 7,
          .hysteresis_beta = 1.5,
          .hysteresis_gamma = -0.7,
          .hysteresis_exponent = exponent};
}

class EveryMethodWithHysteresis : public EveryMethod {};

INSTANTIATE_TEST_SUITE_P(Registry, EveryMethodWithHysteresis, testing::ValuesIn(method_names), name_of_test);

TEST_P(EveryMethodWithHysteresis, HasTheDeclaredOrder) {
  if (info().order == 0) GTEST_SKIP() << "has its closed form only";
  // Until before the velocity or z is zero for the first time: there the law has corners.
  const System system(bouc_wen(1), {0.5, 2, 0.3});
  const Both start{{-0.6, 0}, {0.4, 0.2}};
  const double until = 0.5;
  Both exact = start;
  for (int n = 0; n < 20000; ++n) {
    NoMemory none;
    exact = Rk4{}.step(system, n * until / 20000, until / 20000, exact, none).y;
    ASSERT_GT(exact.v.first, 0);
    ASSERT_GT(exact.v.second, 0);
  }
  const auto errors = [&](int steps) {
    const Both y = end(system, start, until, until / steps);
    return std::array{std::hypot(y.x.first - exact.x.first, (y.v.first - exact.v.first) / 3),
                      std::abs(y.v.second - exact.v.second)};
  };
  const int steps = info().order > 4 ? 40 : info().order == 4 ? 10 : 400;
  const auto coarse = errors(steps), fine = errors(4 * steps);
  for (int i : {0, 1}) EXPECT_NEAR(std::log2(coarse[i] / fine[i]) / 2, info().order, 0.15) << i;
}

TEST_P(EveryMethodWithHysteresis, KeepsTheHystereticForceInItsBound) {
  if (info().order == 0) GTEST_SKIP() << "has its closed form only";
  for (const double exponent : {1.0, 2.0}) {
    const Oscillator<double> law = bouc_wen(exponent);
    const System system(law, {30, 2.5, 0});
    const double bound =
        std::pow(law.hysteresis_stiffness / (law.hysteresis_beta + law.hysteresis_gamma), 1 / exponent);
    double most = 0;
    const Outcome outcome = with_method([&](const auto& method) {
      return solve(system, method, {0, 20}, Both{}, 0.002,
                   [&](double, const Both& y) { most = std::max(most, std::abs(y.v.second)); });
    });
    EXPECT_EQ(outcome.status, Status::reached_end);
    EXPECT_LT(most, bound * 1.005);
    EXPECT_GT(most, bound * 0.95);  // it slips, so that the bound is reached
  }
}

TEST(Hysteresis, MovesWithTheNewVelocityInEulerCromer) {
  const System system(bouc_wen(1), {});
  NoMemory none;
  const Both start{{0.3, 0}, {-0.5, 0.2}};
  const Both y = EulerCromer{}.step(system, 0.0, 0.1, start, none).y;
  EXPECT_EQ(y.v.first, -0.5 + 0.1 * system.acceleration(0.0, start.x, start.v).first);
  EXPECT_EQ(y.v.second, 0.2 + 0.1 * system.rate(y.v.first, 0.2));
  EXPECT_NE(y.v.second, 0.2 + 0.1 * system.rate(-0.5, 0.2));
}

TEST(Hysteresis, LosesTheAreaOfItsLoop) {
  const Oscillator<double> law{
      .stiffness = 0, .hysteresis_stiffness = 7, .hysteresis_beta = 1.2, .hysteresis_gamma = 1.2};
  // A prescribed motion x = X sin t: the law's own rate, by quadrature.
  const double largest = 0.9, h = 1e-4;
  const System system(law, {});
  const auto work_of_cycle = [&](int cycle) {
    double z = 0, work = 0;
    const int steps = static_cast<int>(std::round(2 * std::numbers::pi / h));
    const double dt = 2 * std::numbers::pi / steps;
    for (int n = 0; n < (cycle + 1) * steps; ++n) {
      const double v0 = largest * std::cos(n * dt), v1 = largest * std::cos((n + 0.5) * dt);
      const double middle = z + dt / 2 * system.rate(v0, z);
      if (n >= cycle * steps) work += dt * middle * v1;
      z += dt * system.rate(v1, middle);
    }
    return work;
  };
  // Settled, with b = beta = gamma: while |z| grows z' = (A - 2 b |z|) v, while it falls z' = A v. From the
  // turn at Z the force falls by the straight line to zero and then grows by the exponential to -Z.
  const double a = 7, b = 1.2;
  double z = 0;  // Z at the turns: Z = A/2b (1 - exp(-2b (2X - Z/A)))
  for (int i = 0; i < 200; ++i) z = a / (2 * b) * (1 - std::exp(-2 * b * (2 * largest - z / a)));
  const double length = 2 * largest - z / a;
  const double loading = a / (2 * b) * (length - (1 - std::exp(-2 * b * length)) / (2 * b));
  EXPECT_NEAR(work_of_cycle(6), 2 * (loading - z * z / (2 * a)), 1e-6);
  EXPECT_NEAR(work_of_cycle(7), work_of_cycle(6), 1e-9);
}

TEST(Hysteresis, TakesFromTheMotionWhatItsLoopsEnclose) {
  const System system(bouc_wen(1), {});
  double work = 0, last_force = 0, last_x = 0.8;
  Both end{};
  const Both start{{0.8, 0}, {0, 0}};
  solve(system, Rk4{}, {0, 10}, start, 1e-4, [&](double t, const Both& y) {
    const double force = y.v.second + 0.1 * y.v.first;
    if (t > 0) work += (force + last_force) / 2 * (y.x.first - last_x);
    last_force = force;
    last_x = y.x.first;
    end = y;
  });
  const auto energy = [](const Both& y) { return (y.v.first * y.v.first + 9 * y.x.first * y.x.first) / 2; };
  EXPECT_NEAR(energy(start) - energy(end), work, 1e-7);
  EXPECT_GT(work, 0.5 * energy(start));
}

TEST(Hysteresis, ScalesWithTheMass) {
  // m x'' = -F(x) with all forces times m is the same motion.
  for (const double exponent : {1.0, 1.7}) {
    const Oscillator<double> light = bouc_wen(exponent);
    Oscillator<double> heavy = light;
    heavy.mass = 5;
    heavy.stiffness *= 5;
    heavy.damping *= 5;
    heavy.hysteresis_stiffness *= 5;
    // beta |x'| |z|^(n-1) z with z five times as large
    heavy.hysteresis_beta *= std::pow(5, 1 - exponent);
    heavy.hysteresis_gamma *= std::pow(5, 1 - exponent);
    const auto one = divided_by_mass(light), other = divided_by_mass(heavy);
    EXPECT_DOUBLE_EQ(other.hysteresis_stiffness, one.hysteresis_stiffness);
    EXPECT_DOUBLE_EQ(other.hysteresis_beta, one.hysteresis_beta);
    EXPECT_DOUBLE_EQ(other.hysteresis_gamma, one.hysteresis_gamma);
  }
}

TEST(Hysteresis, ItsRateHasTheDerivativeOfItsDifferences) {
  using D = Dual<double, 2>;
  for (const double exponent : {1.0, 1.5, 3.0})
    for (const double v : {-0.7, 0.4})
      for (const double z : {-1.3, 0.6}) {
        const System system(bouc_wen(exponent), {});
        const D rate = system.rate(D::variable(v, 0), D::variable(z, 1));
        const double h = 1e-6;
        EXPECT_NEAR(rate.derivative[0], (system.rate(v + h, z) - system.rate(v - h, z)) / (2 * h), 1e-8);
        EXPECT_NEAR(rate.derivative[1], (system.rate(v, z + h) - system.rate(v, z - h)) / (2 * h), 1e-8);
      }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
