#include "cromer/study/task/run_energy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cromer {
namespace {

SimulatedRun run_of(const SimulateOptions& options) {
  auto result = simulate(options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().message);
  return result.ok() ? std::move(result->runs.front()) : SimulatedRun{};
}

SimulateOptions at_resonance(const char* method) {
  SimulateOptions options;
  options.stiffness = 9;
  options.damping = 0.2;
  options.drive_amplitude = 1;
  options.drive_frequency = {3};
  options.position = 0.1;
  options.method = {method};
  return options;
}

TEST(RunEnergy, ClosesToRoundingForExact) {
  const auto balance = run_of(at_resonance("exact")).energy_balance;
  ASSERT_TRUE(balance);
  EXPECT_GT(balance->drive, 10);
  EXPECT_LT(std::abs(balance->method()), 1e-13 * balance->drive);
}

TEST(RunEnergy, ClosesForExactUnderAPulse) {
  SimulateOptions options = at_resonance("exact");
  options.drive = "rectangular";
  options.drive_frequency.clear();
  options.drive_start = 0.7;
  options.drive_duration = 1.1;
  const auto balance = run_of(options).energy_balance;
  ASSERT_TRUE(balance);
  EXPECT_GT(std::abs(balance->drive), 0.01);
  EXPECT_LT(std::abs(balance->method()), 1e-11 * (balance->start + std::abs(balance->drive)));
}

TEST(RunEnergy, ImplicitEulerLosesWhatNobodyAskedFor) {
  const auto balance = run_of(at_resonance("implicit-euler")).energy_balance;
  ASSERT_TRUE(balance);
  EXPECT_LT(balance->method(), -0.1 * balance->drive);
}

TEST(RunEnergy, FrictionTakesItsForceTimesThePath) {
  SimulateOptions options;
  options.friction = 0.05;
  options.position = 1;
  options.method = {"rk4"};
  const auto balance = run_of(options).energy_balance;
  ASSERT_TRUE(balance);
  // Half cycles of 1.9, 1.7, ... 0.1 m: it stops at the middle.
  EXPECT_NEAR(balance->friction, 0.5, 1e-3);
  EXPECT_NEAR(balance->method(), 0, 1e-3);
}

TEST(RunEnergy, NeedsDenseStates) {
  SimulateOptions options = at_resonance("rk4");
  options.every = 50;
  EXPECT_FALSE(run_of(options).energy_balance);
}

}  // namespace
}  // namespace cromer
