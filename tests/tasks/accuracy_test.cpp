#include "cromer/documents/words/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::HasSubstr;

/// w = 6 rad/s, b = 0.15 1/s, ten cycles.
SimulateOptions lightly_damped(const char* method, double accuracy) {
  SimulateOptions options;
  options.stiffness = 36;
  options.damping = 0.3;
  options.until = 10;
  options.method = {method};
  options.accuracy = accuracy;
  return options;
}

SimulatedRun run_of(const SimulateOptions& options) {
  auto result = simulate(options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : in_words(result.error()));
  return result.ok() ? std::move(result->runs.front()) : SimulatedRun{};
}

std::string refusal(const SimulateOptions& options) {
  const auto result = simulate(options);
  return result.ok() ? "simulated" : in_words(result.error());
}

TEST(Accuracy, ForwardEulersStepIsItsClosedForm) {
  // Decay rate b - w^2 h/2: within 1 % of b for h = 0.02 b/w^2; the amplitude after 10 s gives about the same
  // limit.
  const SimulatedRun run = run_of(lightly_damped("forward-euler", 0.01));
  ASSERT_TRUE(run.accuracy);
  const double amplitude = std::log1p(0.01) / 10 * 2 / 36, decay = 0.02 * 0.15 / 36;
  EXPECT_NEAR(run.step, std::min(amplitude, decay), 0.01 * run.step);
  EXPECT_EQ(run.accuracy->step, run.step);
  EXPECT_EQ(run.accuracy->asked, 0.01);
  EXPECT_LE(run.accuracy->worst(), 0.01);
}

TEST(Accuracy, EveryMethodKeepsToItAndNoLongerStepWould) {
  for (const char* method :
       {"euler-cromer", "implicit-euler", "verlet", "rk4", "newmark", "gauss-legendre4"}) {
    const SimulatedRun run = run_of(lightly_damped(method, 1e-3));
    ASSERT_TRUE(run.accuracy) << method;
    EXPECT_LE(run.accuracy->worst(), 1e-3) << method;
    EXPECT_GT(run.accuracy->worst(), 0.95e-3) << method;
    EXPECT_NEAR(std::round(10 / run.step) * run.step, 10, 1e-9) << method;
    EXPECT_EQ(run.outcome.status, Status::reached_end) << method;
  }
}

TEST(Accuracy, VerletsFrequencySetsItsStep) {
  // Undamped: w' = 2/h asin(w h/2), an error of (w h)^2/24.
  SimulateOptions options = lightly_damped("verlet", 1e-3);
  options.damping = 0;
  const SimulatedRun run = run_of(options);
  EXPECT_NEAR(run.step, std::sqrt(24e-3) / 6, 0.02 * run.step);
  EXPECT_FALSE(run.accuracy->decay_error);
  EXPECT_LT(run.accuracy->amplitude_error, 1e-9);
}

TEST(Accuracy, ADrivenRunKeepsItsSteadyAmplitude) {
  SimulateOptions options = lightly_damped("verlet", 1e-3);
  options.drive_amplitude = 1;
  options.drive_frequency = {6};
  const SimulatedRun driven = run_of(options);
  // At resonance a shift of the frequency tells more than in the free motion.
  EXPECT_LT(driven.step, run_of(lightly_damped("verlet", 1e-3)).step);
  EXPECT_LE(driven.accuracy->worst(), 1e-3);
}

TEST(Accuracy, AShakingBaseIsTheForceThatItMakes) {
  auto force = lightly_damped("verlet", 1e-3);
  force.drive_frequency = {4};
  auto base = force;
  force.drive_amplitude = 0.01 * 16;
  base.drive = "base";
  base.base_displacement = 0.01;
  const SimulatedRun by_force = run_of(force), by_base = run_of(base);
  EXPECT_EQ(by_base.step, by_force.step);
  // Both are measured on a run; what is only predicted differs in the last digits.
  EXPECT_EQ(by_base.accuracy->frequency_error, by_force.accuracy->frequency_error);
  EXPECT_EQ(by_base.accuracy->decay_error, by_force.accuracy->decay_error);
}

TEST(Accuracy, DuffingIsMeasuredAgainstAFineReference) {
  SimulateOptions options;
  options.law.cubic = 1;
  options.damping = 0.05;
  options.position = 1;
  options.until = 50;
  options.method = {"rk4"};
  options.accuracy = 1e-4;
  const SimulatedRun run = run_of(options);
  ASSERT_TRUE(run.accuracy);
  ASSERT_TRUE(run.accuracy->frequency_error && run.accuracy->decay_error);
  EXPECT_LE(run.accuracy->worst(), 1e-4);
  EXPECT_GT(run.accuracy->worst(), 0.5e-4);
  ASSERT_TRUE(run.measured);
  EXPECT_GT(run.measured->half_cycles, 15);
}

TEST(Accuracy, AnyDriveCanBeMeasured) {
  for (const char* drive : {"step", "half-sine", "chirp"}) {
    SimulateOptions options = lightly_damped("rk4", 0.01);
    options.drive = drive;
    options.drive_amplitude = 1;
    options.drive_start = 1;
    if (std::string_view(drive) == "half-sine") options.drive_duration = 0.5;
    if (std::string_view(drive) == "chirp") {
      options.drive_frequency = {1};
      options.drive_to = 8;
    }
    const SimulatedRun run = run_of(options);
    ASSERT_TRUE(run.accuracy) << drive;
    EXPECT_LE(run.accuracy->amplitude_error, 0.01) << drive;
    EXPECT_GT(run.accuracy->step, 0.02) << drive;
  }
}

TEST(Accuracy, ExactNeedsNone) {
  const SimulatedRun run = run_of(lightly_damped("exact", 1e-3));
  EXPECT_FALSE(run.accuracy);
  EXPECT_NEAR(run.step, 2 * 3.14159265358979 / 6 / 200, 1e-9);
}

TEST(Accuracy, SaysWhatItCannotDo) {
  SimulateOptions options = lightly_damped("rk4", 1e-3);
  options.step = 0.01;
  EXPECT_THAT(refusal(options), HasSubstr("--step and --accuracy both set the step"));
  EXPECT_THAT(refusal(lightly_damped("dormand-prince", 1e-3)), HasSubstr("give --tolerance instead"));
  EXPECT_THAT(refusal(lightly_damped("rk4", 0)), HasSubstr("--accuracy: it must lie between"));
  EXPECT_THAT(refusal(lightly_damped("forward-euler", 1e-9)), HasSubstr("--accuracy"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
