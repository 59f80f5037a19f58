// Of van der Pol's equation x'' - mu (1 - x²) x' + x = 0 the largest displacement is 2 but for
// little: 2.00862 at mu = 1, from a run of our own in steps of 1e-4.
#include "cromer/analysis/limit_cycle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cromer::core {
namespace {

constexpr double period = 2 * std::numbers::pi;

Oscillator<double> van_der_pol(double mu) {
  return {.mass = 1, .stiffness = 1, .damping = -mu, .van_der_pol = mu};
}

TEST(LimitCycle, IsTwoWhereTheDampingIsSmall) {
  for (const double near : {1.0, 1.9, 4.0}) {
    const auto amplitude = limit_cycle_amplitude(van_der_pol(1e-3), near, period);
    ASSERT_TRUE(amplitude);
    EXPECT_NEAR(*amplitude, 2, 1e-6);
  }
}

TEST(LimitCycle, IsALittleMoreWhereItIsLarge) {
  const auto amplitude = limit_cycle_amplitude(van_der_pol(1), 2, period);
  ASSERT_TRUE(amplitude);
  EXPECT_NEAR(*amplitude, 2.00862, 1e-5);
}

TEST(LimitCycle, NoneWithoutABound) {
  EXPECT_FALSE(limit_cycle_amplitude({.mass = 1, .stiffness = 1, .damping = -0.1}, 1, period));
  EXPECT_FALSE(limit_cycle_amplitude({.mass = 1, .stiffness = 1, .damping = 0.1}, 1, period));
}

TEST(LimitCycle, MayBeHeldUpByFriction) {
  // x'' - 2 b x' + x + f sgn x' = 0: A - f grows by exp(pi b/wd) in half a cycle, and f is lost again.
  const double b = 0.05, f = 0.1, growth = std::exp(std::numbers::pi * b / std::sqrt(1 - b * b));
  const auto amplitude =
      limit_cycle_amplitude({.mass = 1, .stiffness = 1, .damping = -2 * b, .friction = f}, 1.2, period);
  ASSERT_TRUE(amplitude);
  EXPECT_NEAR(*amplitude, f * (growth + 1) / (growth - 1), 1e-3);
}

TEST(LimitCycle, IsLookedForWithinTenPeriods) {
  const auto found = [](double periods) {
    return limit_cycle_amplitude(van_der_pol(1e-3), 1.9, period / periods);
  };
  ASSERT_TRUE(found(9.9));
  EXPECT_NEAR(*found(9.9), 2, 1e-6);
  EXPECT_FALSE(found(10.1));
}

TEST(LimitCycle, IsOfTheSideThatItBeginsOn) {
  // The quadratic spring is weaker there: the turn is further out than the other one.
  const Oscillator<double> law{
      .mass = 1, .stiffness = 1, .damping = -0.01, .quadratic = -0.2, .van_der_pol = 0.01};
  const auto right = limit_cycle_amplitude(law, 2.2, period);
  Oscillator<double> mirrored = law;
  mirrored.quadratic = 0.2;
  const auto left = limit_cycle_amplitude(mirrored, 1.8, period);
  ASSERT_TRUE(right && left);
  // To second order of k2 A the middle is at -k2 A^2/3 for turning points, A = 2.
  EXPECT_NEAR(*right - *left, 2 * 0.2 * 4 / 3, 0.15);
  EXPECT_GT(*right, 2);
}

}  // namespace
}  // namespace cromer::core
