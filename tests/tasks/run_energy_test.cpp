#include "cromer/tasks/simulate/run_energy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "cromer/analysis/energy.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/simulate/simulate.h"
#include "tests/support/simulated.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

SimulatedRun run_of(const SimulateOptions& options) {
  auto result = simulate(options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : in_words(result.error()));
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

TEST(RunEnergy, AJumpIsNotTakenForTheMethodsDoing) {
  for (const char* drive : {"step", "rectangular", "half-sine", "chirp"}) {
    SimulateOptions options = at_resonance("gauss-legendre4");
    options.drive = drive;
    options.drive_frequency.clear();
    options.drive_start = 0.7;
    if (std::string_view(drive) != "step") options.drive_duration = 1.1;
    if (std::string_view(drive) == "chirp") {
      options.drive_frequency = {1};
      options.drive_to = 8;
    }
    options.step = 0.01;
    options.until = 5;
    const auto balance = run_of(options).energy_balance;
    ASSERT_TRUE(balance) << drive;
    EXPECT_GT(std::abs(balance->drive), 1e-3) << drive;
    EXPECT_LT(std::abs(balance->method()), 1e-7 * (balance->start + std::abs(balance->drive))) << drive;
    // Between two states nothing is known of it.
    options.drive_start = 0.7053;
    EXPECT_FALSE(run_of(options).energy_balance) << drive;
  }
}

TEST(RunEnergy, ImplicitEulerLosesWhatNobodyAskedFor) {
  const auto balance = run_of(at_resonance("implicit-euler")).energy_balance;
  ASSERT_TRUE(balance);
  EXPECT_LT(balance->method(), -0.1 * balance->drive);
}

TEST(RunEnergy, FrictionTakesItsForceTimesThePath) {
  SimulateOptions options;
  options.law.friction = 0.05;
  options.position = 1;
  options.method = {"rk4"};
  const auto balance = run_of(options).energy_balance;
  ASSERT_TRUE(balance);
  // Half cycles of 1.9, 1.7, ... 0.1 m: it stops at the middle.
  EXPECT_NEAR(balance->taken_by<Friction>(), 0.5, 1e-3);
  EXPECT_NEAR(balance->method(), 0, 1e-3);
}

/// Dry friction by `exact`, from 1 m.
SimulateOptions rubbing() {
  SimulateOptions options;
  options.stiffness = 9;
  options.law.friction = 0.05;
  options.position = 1;
  options.method = {"exact"};
  return options;
}

/// What the method seems to have made, over the largest energy.
double left_over(const EnergyBalance& b) {
  return std::abs(b.method()) /
         std::max({b.start, std::abs(b.end), b.taken_by<Viscous>() + b.taken_by<Friction>()});
}

TEST(RunEnergy, ClosesToRoundingForExactWithFriction) {
  struct Case {
    const char* name;
    double stiffness, damping, friction, static_friction, velocity;
  };
  for (const Case& c :
       {Case{"friction alone", 9, 0, 0.05, 0.05, 0}, Case{"with damping", 9, 0.2, 0.05, 0.05, -2},
        Case{"holding more than it brakes", 9, 0.1, 0.05, 3, 1},
        Case{"static friction alone", 9, 0.1, 0, 3, 1}, Case{"aperiodic", 9, 20, 0.05, 0.05, 4},
        Case{"all but aperiodic", 9, 5.99, 0.05, 0.05, 4}, Case{"strongly damped", 9, 5e4, 0.05, 0.05, 4},
        Case{"no spring", 0, 0.3, 0.05, 0.05, 2}, Case{"falling over", -1, 0.3, 0.05, 0.05, 0}}) {
    // Within the first arc, between stops, long after the last one; rows close together and far apart.
    for (const double until : {0.3, 2.9, 5.0, 400.0})
      for (const double step : {0.01, 0.37, 2.9, 400.0}) {
        if (c.stiffness < 0 && until > 5) continue;
        SimulateOptions options = rubbing();
        options.stiffness = c.stiffness;
        options.damping = c.damping;
        options.law.friction = c.friction;
        options.static_friction = c.static_friction;
        options.velocity = c.velocity;
        options.until = until;
        options.step = step;
        const SimulatedRun run = run_of(options);
        ASSERT_TRUE(run.energy_balance) << c.name << ' ' << until << ' ' << step;
        const EnergyBalance& b = *run.energy_balance;
        EXPECT_LT(left_over(b), 1e-14) << c.name << ' ' << until << ' ' << step;
        EXPECT_NEAR(b.end, energy(run.oscillator, run.outcome.y), 1e-14 * std::abs(b.start));
        EXPECT_EQ(b.drive, 0);
        EXPECT_EQ(b.taken_by<Drag>(), 0);
      }
  }
}

TEST(RunEnergy, FrictionTakesTheEnergyBetweenTheStops) {
  // Stops at 1, -0.9, 0.8, ... m: f/k = 0.05 m of it either way, the last at 0 or where friction holds.
  SimulateOptions options = rubbing();
  options.law.friction = 0.45;
  options.until = 3.5 * std::acos(-1) / 3;  // three half periods, and half of the fourth
  const EnergyBalance b = *run_of(options).energy_balance;
  EXPECT_NEAR(b.taken_by<Friction>(), 0.45 * (1.9 + 1.7 + 1.5 + 0.65), 1e-14);
  EXPECT_EQ(b.taken_by<Viscous>(), 0);
}

TEST(RunEnergy, WhatSticksAtOnceTakesNothing) {
  SimulateOptions options = rubbing();
  options.static_friction = 9.1;
  options.until = 100;
  const EnergyBalance b = *run_of(options).energy_balance;
  EXPECT_EQ(b.end, b.start);
  EXPECT_EQ(b.taken_by<Friction>(), 0);
  EXPECT_EQ(b.method(), 0);
}

TEST(RunEnergy, ClosesOverManyArcs) {
  // It still moves after 4775 stops. Each arc shrinks the swing by the same factor, rounded the same way: a
  // rounding of the energy each.
  SimulateOptions options = rubbing();
  options.law.friction = 1e-4;
  options.damping = 1e-5;
  options.until = 5000;
  options.step = 1;
  const EnergyBalance b = *run_of(options).energy_balance;
  EXPECT_GT(b.end, 0.5);
  EXPECT_GT(b.taken_by<Friction>(), 0.1);
  EXPECT_GT(b.taken_by<Viscous>(), 0.01);
  EXPECT_LT(left_over(b), 4775 * 2e-16);
}

TEST(RunEnergy, NeedsDenseStates) {
  SimulateOptions options = at_resonance("rk4");
  options.every = 50;
  EXPECT_FALSE(run_of(options).energy_balance);
}

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

}  // namespace CROMER_FILE
}  // namespace cromer::core
