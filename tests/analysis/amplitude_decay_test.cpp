#include "cromer/analysis/amplitude_decay.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cromer/methods/rk4.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace {

/// ln of the ratio of the turning points a period apart, over the period: the amplitude falls by its mean
/// rate.
double simulated_rate(const Oscillator<double>& law, double A, double periods) {
  const double period = 2 * std::numbers::pi;
  KeepEvery keep(1, count_steps({0, periods * period}, period / 1000));
  with_terms(law, HarmonicDrive<double>{}, [&](const auto& system) {
    return solve(system, Rk4{}, Interval{0, periods * period}, State<double>{A, 0}, period / 1000, keep);
  });
  const Trajectory motion = keep.take();
  const double last = std::hypot(motion.x.back(), motion.v.back());
  return std::log(A / last) / (motion.t.back());
}

TEST(AmplitudeDecay, IsTheMeanOverACycleOfEveryTerm) {
  const double A = 0.5;
  const AmplitudeDecay viscous{.angular_frequency = 1, .per_mass = {.damping = 0.002}};
  EXPECT_NEAR(simulated_rate({.mass = 1, .stiffness = 1, .damping = 0.002}, A, 1) / viscous.rate(A), 1, 2e-3);
  const AmplitudeDecay drag{.angular_frequency = 1, .per_mass = {.drag = 0.001}};
  EXPECT_NEAR(simulated_rate({.mass = 1, .stiffness = 1, .drag = 0.001}, A, 1) / drag.rate(A), 1, 3e-3);
  EXPECT_NEAR(drag.rate(2 * A) / drag.rate(A), 2, 1e-14);
}

TEST(AmplitudeDecay, FrictionTakesTheSameAmplitudeEveryCycle) {
  // Exactly 4 f/(m w^2) a cycle.
  const AmplitudeDecay friction{.angular_frequency = 2, .per_mass = {.friction = 0.003}};
  const double period = std::numbers::pi, a_cycle = 4 * 0.003 / 4;
  EXPECT_NEAR(friction.rate(0.1) * 0.1 * period, a_cycle, 1e-15);
  EXPECT_NEAR(friction.rate(0.2) * 0.2 * period, a_cycle, 1e-15);
}

}  // namespace
}  // namespace cromer::core
