// Of van der Pol's equation x'' - mu (1 - x²) x' + x = 0 the largest displacement is 2 but for
// little: 2.00862 at mu = 1, from a run of our own in steps of 1e-4.
#include "cromer/analysis/limit_cycle.h"

#include <gtest/gtest.h>

#include <numbers>

namespace cromer {
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

}  // namespace
}  // namespace cromer
