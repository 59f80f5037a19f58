#include "cromer/tasks/simulate/run_invariants.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/tasks/simulate/simulate.h"
#include "tests/support/simulated.h"

namespace cromer::core {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const SimulateOptions spring{
    .mass = 2, .stiffness = 72, .position = 0.5, .velocity = 1, .step = 0.01, .until = 100};

TEST(ModifiedEnergy, IsKeptWhereTheEnergySwings) {
  const auto found = run(spring).modified_energy;
  ASSERT_TRUE(found);
  // m/2 (v^2 + w^2 x^2 - h w^2 x v), w = 6: 1 + 9 - 0.18.
  EXPECT_DOUBLE_EQ(found->start, 9.82);
  EXPECT_LT(found->drift, 1e-13);
  EXPECT_LE(std::abs(found->end / found->start - 1), found->drift);
  EXPECT_NEAR(found->energy_swing, 6 * 0.01 / 2, 1e-4);
  EXPECT_EQ(found->states, 10001);
}

TEST(ModifiedEnergy, LooksAtTheKeptStates) {
  SimulateOptions options = spring;
  options.every = 100;
  EXPECT_EQ(run(options).modified_energy->states, 101);
}

TEST(ModifiedEnergy, LeavesOutAStateThatPartOfAStepReached) {
  // A step of another length conserves another energy.
  SimulateOptions options = spring;
  options.until = 100.005;
  const SimulatedRun cut = run(options);
  EXPECT_EQ(cut.trajectory.size(), 10002u);
  EXPECT_EQ(cut.modified_energy->states, 10001);
  EXPECT_LT(cut.modified_energy->drift, 1e-13);
  options.event = {"turning-point:stop"};
  const SimulatedRun stopped = run(options);
  EXPECT_EQ(stopped.outcome.status, Status::stopped_by_event);
  ASSERT_GT(stopped.modified_energy->states, 1);
  EXPECT_LT(stopped.modified_energy->drift, 1e-13);
}

TEST(ModifiedEnergy, CompensatedSumsKeepItOverAMillionSteps) {
  // docs/methods.md has the figures of 1e8 steps.
  SimulateOptions options = spring;
  options.until = 1e4;
  options.every = 100;
  const double ordinary = run(options).modified_energy->drift;
  options.compensated = true;
  const double compensated = run(options).modified_energy->drift;
  EXPECT_LT(compensated, 1e-13);
  EXPECT_GT(ordinary, 10 * compensated);
}

TEST(ModifiedEnergy, IsSaidOnlyWhereItIsConserved) {
  const auto without = [](auto change) {
    SimulateOptions options = spring;
    change(options);
    return !run(options).modified_energy;
  };
  EXPECT_TRUE(without([](auto& o) { o.damping = 0.1; }));
  EXPECT_TRUE(without([](auto& o) { o.law.drag = 0.1; }));
  EXPECT_TRUE(without([](auto& o) { o.law.cubic = 1; }));
  EXPECT_TRUE(without([](auto& o) { o.law.friction = 0.1; }));
  EXPECT_TRUE(without([](auto& o) { o.drive_amplitude = 1, o.drive_frequency = {3}; }));
  EXPECT_TRUE(without([](auto& o) { o.drive = "step", o.drive_amplitude = 1; }));
  EXPECT_TRUE(without([](auto& o) { o.method = {"rk4"}; }));
  EXPECT_TRUE(without([](auto& o) { o.position = o.velocity = 0; })) << "at rest there is none";
  EXPECT_TRUE(without([](auto& o) { o.step = 0.4, o.until = 4; })) << "w h > 2: it is no ellipse";
  EXPECT_FALSE(without([](auto& o) { o.step = 0.3, o.until = 3; }));
}

TEST(ModifiedEnergy, IsSaidInWords) {
  EXPECT_THAT(in_words(modified_energy_notice(run(spring))),
              AllOf(StartsWith("euler-cromer conserves a modified energy"), HasSubstr("= 9.82 J"),
                    HasSubstr("10001 kept states;"), HasSubstr("swings by 3 %")));
  SimulateOptions options = spring;
  options.compensated = true;
  EXPECT_THAT(in_words(modified_energy_notice(run(options))), HasSubstr("kept states (compensated sums)"));
  options.method = {"rk4"};
  EXPECT_EQ(in_words(modified_energy_notice(run(options))), "");
}

}  // namespace
}  // namespace cromer::core
