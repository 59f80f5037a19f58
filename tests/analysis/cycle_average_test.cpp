// The averages of Bogoliubov and Mitropolsky as they are printed, and Gauss's rule below them.
#include "cromer/analysis/cycle_average.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cromer/analysis/amplitude_decay.h"

namespace cromer::core {
namespace {

constexpr double pi = std::numbers::pi;

TEST(GaussRule, IsExactUpToDegreeFifteen) {
  for (int degree = 0; degree <= 15; ++degree) {
    const double mean = mean_over(1.0, 3.0, [&](double x) { return std::pow(x, degree); });
    const double exact = (std::pow(3, degree + 1) - 1) / (2 * (degree + 1));
    EXPECT_NEAR(mean / exact, 1, 1e-14) << degree;
  }
  EXPECT_GT(std::abs(mean_over(-1.0, 1.0, [](double x) { return std::pow(x, 16); }) - 1.0 / 17), 1e-6);
}

TEST(CycleAverage, FallsAreThePrintedOnes) {
  for (const double A : {0.3, 2.0})
    for (const double w : {0.7, 5.0}) {
      EXPECT_NEAR((cycle_average<Viscous>(A, w).fall) / (A / 2), 1, 1e-13);
      EXPECT_NEAR((cycle_average<Drag>(A, w).fall) / (4 * w * A * A / (3 * pi)), 1, 1e-10);
      EXPECT_NEAR((cycle_average<Friction>(A, w).fall) / (2 / (pi * w)), 1, 1e-12);
      EXPECT_NEAR((cycle_average<VanDerPol>(A, w).fall) / (A * A * A / 8), 1, 1e-10);
      EXPECT_EQ((cycle_average<Viscous>(A, w).shift), 0);
      EXPECT_EQ((cycle_average<Drag>(A, w).shift), 0);
      EXPECT_EQ((cycle_average<Friction>(A, w).shift), 0);
      EXPECT_EQ((cycle_average<VanDerPol>(A, w).shift), 0);
    }
}

TEST(CycleAverage, ShiftsAreThePrintedOnes) {
  for (const double A : {0.3, 2.0})
    for (const double w : {0.7, 5.0}) {
      EXPECT_NEAR((cycle_average<Cubic>(A, w).shift) / (3 * A * A / (8 * w)), 1, 1e-10);
      EXPECT_NEAR((cycle_average<OddQuadratic>(A, w).shift) / (4 * A / (3 * pi * w)), 1, 1e-10);
      EXPECT_NEAR((cycle_average<Quintic>(A, w).shift) / (5 * std::pow(A, 4) / (16 * w)), 1, 1e-10);
      // sin(A cos theta) has the first harmonic 2 J1(A).
      EXPECT_NEAR((cycle_average<Pendulum>(A, w).shift) / (std::cyl_bessel_j(1, A) / (A * w)), 1, 2e-9);
      EXPECT_EQ((cycle_average<Quadratic>(A, w).shift), 0) << "of second order";
      EXPECT_EQ((cycle_average<Cubic>(A, w).fall), 0);
      EXPECT_EQ((cycle_average<Quadratic>(A, w).fall), 0);
      EXPECT_EQ((cycle_average<Pendulum>(A, w).fall), 0);
    }
}

TEST(AmplitudeDecay, IsTheSumOfWhatEachTermTakes) {
  const double w = 3, A = 0.7;
  const AmplitudeDecay law{
      .angular_frequency = w,
      .per_mass = {
          .stiffness = 9, .damping = 0.04, .drag = 0.02, .friction = 0.05, .cubic = 4, .van_der_pol = 0.03}};
  const double s = 2 * 0.05 / (pi * w), q = 4 * 0.02 * w / (3 * pi);
  EXPECT_NEAR(law.rate(A) * A, s + 0.02 * A + q * A * A + 0.03 * A * A * A / 8, 1e-12);
  EXPECT_NEAR((AmplitudeDecay{.per_mass = {.friction = 1}}.rate(1)), 2 / pi, 1e-12)
      << "1 rad/s if nobody says";
  EXPECT_EQ((AmplitudeDecay{.angular_frequency = w, .per_mass = {.stiffness = 9, .cubic = 4}}.rate(A)), 0);
}

}  // namespace
}  // namespace cromer::core
