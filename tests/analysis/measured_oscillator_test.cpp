#include "cromer/analysis/measured_oscillator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cromer/methods/euler_cromer.h"
#include "cromer/methods/exact.h"
#include "cromer/methods/forward_euler.h"
#include "cromer/methods/rk4.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

namespace cromer {
namespace {

/// Of a law of 1 kg.
template <Terms terms = Terms{.law = law_of("viscous")}, class M>
Trajectory run(const M& method, const Oscillator<double>& law, const State<double>& start, double until,
               double step) {
  KeepEvery keep(1, count_steps({0, until}, step));
  const DrivenOscillator<double, terms> system(law, {});
  solve(system, method, {0, until}, start, {step}, keep);
  return keep.take();
}

const Oscillator<double> damped{.mass = 1, .stiffness = 36, .damping = 0.3};  // b = 0.15 1/s

TEST(MeasuredOscillator, FindsTheLinearLaw) {
  const auto measured = measure_oscillator(run(Exact{}, damped, {1, 0}, 20, 0.005));
  ASSERT_TRUE(measured);
  const double wd = std::sqrt(36 - 0.15 * 0.15);
  EXPECT_NEAR(measured->angular_frequency, wd, 1e-9 * wd);
  EXPECT_NEAR(measured->decay_rate, 0.15, 1e-7);
  EXPECT_EQ(measured->half_cycles, 38);
  EXPECT_NEAR(measured->first_amplitude, (1 + std::exp(-0.15 * std::numbers::pi / wd)) / 2, 1e-8);
}

TEST(MeasuredOscillator, TurningPointsKeepToTheirErrors) {
  const double half = std::numbers::pi / 6;
  for (const double h : {0.05, 0.025, 0.0125}) {
    const auto turns = turning_points(run(Exact{}, {.mass = 1, .stiffness = 36}, {0.6, 1.9}, 5, h));
    const double phase = std::atan2(1.9 / 6, 0.6) / 6;
    ASSERT_GE(turns.size(), 9u);
    EXPECT_NEAR(turns[8].t, phase + 8 * half, 0.02 * std::pow(6 * h, 3) / 6);
    EXPECT_NEAR(turns[8].x, std::hypot(0.6, 1.9 / 6), std::pow(6 * h, 4) / 300);
  }
}

TEST(MeasuredOscillator, FindsTheDuffingOscillatorsFrequency) {
  // x'' + x + x^3 = 0 from x = 1: T = 4 K(m)/sqrt(1 + A^2), m = A^2/(2 (1 + A^2)) = 1/4, K by the arithmetic
  // and geometric mean: pi/(2 agm(1, sqrt(1 - m))).
  double a = 1, g = std::sqrt(0.75);
  for (int i = 0; i < 6; ++i) {
    const double mean = (a + g) / 2;
    g = std::sqrt(a * g);
    a = mean;
  }
  const double period = 4 * std::numbers::pi / (2 * a) / std::sqrt(2);
  const auto measured = measure_oscillator(
      run<Terms{.law = law_of("cubic")}>(Rk4{}, {.mass = 1, .stiffness = 1, .cubic = 1}, {1, 0}, 100, 0.002));
  ASSERT_TRUE(measured);
  EXPECT_NEAR(measured->angular_frequency, 2 * std::numbers::pi / period, 1e-9);
  EXPECT_NEAR(measured->decay_rate, 0, 1e-10);
  EXPECT_NEAR(measured->last_amplitude, 1, 1e-9);
}

TEST(MeasuredOscillator, SeesNoOscillationWhereThereIsNone) {
  EXPECT_FALSE(measure_oscillator(run(Exact{}, {.mass = 1, .stiffness = 1, .damping = 5}, {1, 0}, 10, 0.1)));
  EXPECT_FALSE(measure_oscillator({}));
}

TEST(Recurrence, IsTheMethodsOwnOscillatorToRounding) {
  const double h = 0.01, b = 0.15, w = 6;
  // Euler-Cromer's closed form.
  const auto cromer = measure_recurrence(run(EulerCromer{}, damped, {1, 0}, 20, h).x, h, w);
  ASSERT_TRUE(cromer);
  EXPECT_NEAR(cromer->decay_rate, -std::log(1 - 2 * b * h) / (2 * h), 1e-12);
  EXPECT_NEAR(cromer->angular_frequency,
              std::acos((1 - b * h - w * w * h * h / 2) / std::sqrt(1 - 2 * b * h)) / h, 1e-12 * w);
  // Forward Euler grows.
  const auto forward = measure_recurrence(run(ForwardEuler{}, damped, {1, 0}, 20, h).x, h, w);
  ASSERT_TRUE(forward);
  EXPECT_NEAR(forward->decay_rate, -std::log(1 - 2 * b * h + w * w * h * h) / (2 * h), 1e-12);
}

TEST(Recurrence, NeedsAnOscillation) {
  EXPECT_FALSE(measure_recurrence({}, 0.1, 1));
  EXPECT_FALSE(measure_recurrence(std::vector<double>(100, 0.0), 0.1, 1));
  EXPECT_FALSE(measure_recurrence(std::vector<double>(100, 1.0), 0.1, 1));
}

}  // namespace
}  // namespace cromer
