// The named results of simulated runs: every number of handmade ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/study/collected.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::DoubleEq;
using testing::ElementsAre;

/// A free undamped motion of 1 kg on 1 N/m whose kept states have the energies 2, 3, 1 and 2.5 J.
SimulatedRun free_run() {
  SimulatedRun run;
  run.method = "rk4";
  run.label = "rk4, as told";
  run.oscillator.mass = 1;
  run.oscillator.stiffness = 1;
  run.step = 0.5;
  run.until = 1.5;
  run.trajectory = {{0, 0.5, 1, 1.5}, {2, -2, 0, 1}, {0, -std::sqrt(2), std::sqrt(2), 2}};
  run.outcome.t = 1.5;
  run.outcome.y = {1, 2};
  run.outcome.counts = {.accepted = 4, .evaluations = 12, .newton_iterations = 10};
  return run;
}

Results collected(const SimulatedRun& run) {
  Results results;
  SimulateResult both;
  both.runs = {free_run(), run};
  collect("swing", both, results);
  return results;
}

TEST(CollectSimulate, SaysWhatEachRunIsAndDid) {
  const Results results = collected(free_run());
  for (const char* name : {"swing.1", "swing.2"}) {
    const auto of = [&, name](const char* what) { return fact(results, std::string(name) + what); };
    EXPECT_EQ(of(".label"), "rk4, as told");
    EXPECT_EQ(of(".method"), "rk4");
    EXPECT_EQ(of(".step"), "0.5 s");
    EXPECT_EQ(of(".until"), "1.5 s");
    EXPECT_EQ(of(".steps"), "4");
    EXPECT_EQ(of(".newton_iterations"), "10");
    EXPECT_EQ(of(".newton_per_step"), "2.5");
    EXPECT_EQ(of(".peak"), "2 m");
    EXPECT_EQ(of(".peak_velocity"), "2 m/s");
    EXPECT_EQ(of(".final.x"), "1 m");
    EXPECT_EQ(of(".final.v"), "2 m/s");
    EXPECT_EQ(of(".drive_frequency"), "0 rad/s");
    EXPECT_EQ(of(".transmissibility.ratio"), "none");
    EXPECT_EQ(of(".exact.amplitude"), "none");
  }
  EXPECT_EQ(fact(results, "swing.0.label"), "none");
  EXPECT_EQ(fact(results, "swing.3.label"), "none");
  EXPECT_THAT(column(results, "swing.2.energy").values,
              ElementsAre(DoubleEq(2), DoubleEq(3), DoubleEq(1), DoubleEq(2.5)));
  EXPECT_EQ(column(results, "swing.2.energy").unit, "J");
  EXPECT_THAT(column(results, "swing.2.t").values, ElementsAre(0, 0.5, 1, 1.5));
  EXPECT_THAT(column(results, "swing.2.x").values, ElementsAre(2, -2, 0, 1));
  EXPECT_THAT(column(results, "swing.2.v").values[3], 2);
  EXPECT_EQ(column(results, "swing.2.x").name, "position *x*");
}

TEST(CollectSimulate, SaysWhatTheEnergyOfAFreeMotionDid) {
  SimulatedRun run = free_run();
  run.modified_energy = ModifiedEnergy{.start = 3, .drift = 0.25};
  const Results results = collected(run);
  EXPECT_EQ(fact(results, "swing.2.energy_start"), "2 J");
  EXPECT_DOUBLE_EQ(value(results, "swing.2.energy_end"), 2.5);
  EXPECT_DOUBLE_EQ(value(results, "swing.2.energy_ratio"), 1.25);
  EXPECT_DOUBLE_EQ(value(results, "swing.2.energy_swing"), 0.5);
  EXPECT_EQ(fact(results, "swing.2.modified_energy.start"), "3 J");
  EXPECT_EQ(fact(results, "swing.2.modified_energy.drift"), "0.25");
  EXPECT_EQ(fact(results, "swing.1.modified_energy.start"), "none");
  const double factor = value(results, "swing.2.energy_factor_per_cycle");
  // The factor over 2 pi s and the drift over 1.5 s have the same rate.
  EXPECT_NEAR(value(results, "swing.2.energy_drift"), std::pow(factor, 1.5 / (2 * std::numbers::pi)) - 1,
              1e-12);
}

TEST(CollectSimulate, OfARunThatStartsAtRestOrIsDrivenTheEnergyIsNoMeasure) {
  SimulatedRun rest = free_run(), driven = free_run(), pushed = free_run(), loose = free_run();
  rest.trajectory.x[0] = 0;
  driven.drive.amplitude = 1;
  pushed.general = PulseDrive<double>{};
  loose.oscillator.stiffness = 0;
  for (const SimulatedRun& run : {rest, driven, pushed, loose})
    EXPECT_EQ(fact(collected(run), "swing.2.energy_start"), "none");
}

TEST(CollectSimulate, AnExplicitMethodHasNoIterations) {
  SimulatedRun run = free_run();
  run.outcome.counts.newton_iterations = 0;
  EXPECT_EQ(fact(collected(run), "swing.2.newton_per_step"), "–");
  run.outcome.counts.newton_iterations = 1;
  EXPECT_EQ(fact(collected(run), "swing.2.newton_per_step"), "0.25");
}

/// 12 cycles of 3 cos(2 t - 1) under cos(2 t), 40 states a cycle.
SimulatedRun driven_run() {
  SimulatedRun run = free_run();
  run.oscillator.damping = 0.5;
  run.drive = {.amplitude = 1, .frequency = 2, .phase = 0};
  run.trajectory = {};
  for (int i = 0; i <= 480; ++i) {
    const double t = i * std::numbers::pi / 40;
    run.trajectory.t.push_back(t);
    run.trajectory.x.push_back(3 * std::cos(2 * t - 1));
    run.trajectory.v.push_back(-6 * std::sin(2 * t - 1));
  }
  return run;
}

TEST(CollectSimulate, PutsWhatSettledBesideWhatShould) {
  // k - m w^2 = -3, c w = 1: the amplitude is 1/sqrt(10), the lag pi - atan(1/3).
  const double amplitude = 1 / std::sqrt(10), lag = std::numbers::pi - std::atan(1.0 / 3);
  const Results results = collected(driven_run());
  EXPECT_EQ(fact(results, "swing.2.drive_frequency"), "2 rad/s");
  EXPECT_NEAR(value(results, "swing.2.exact.amplitude"), amplitude, 1e-12);
  EXPECT_NEAR(value(results, "swing.2.exact.phase"), lag, 1e-12);
  EXPECT_NEAR(value(results, "swing.2.steady.amplitude"), 3, 1e-3);
  EXPECT_NEAR(value(results, "swing.2.steady.phase"), 1, 1e-3);
  EXPECT_NEAR(value(results, "swing.2.steady.change"), 0, 1e-3);
  EXPECT_NEAR(value(results, "swing.2.amplitude_error"), 3 / amplitude - 1, 1e-2);
  EXPECT_NEAR(value(results, "swing.2.phase_error"), 1 - lag, 1e-3);
}

TEST(CollectSimulate, WithoutDampingNothingIsTheRightPlaceToSettle) {
  SimulatedRun run = driven_run();
  run.oscillator.damping = 0;
  const Results free_of_damping = collected(run);
  EXPECT_EQ(fact(free_of_damping, "swing.2.exact.amplitude"), "none");
  EXPECT_NEAR(value(free_of_damping, "swing.2.steady.amplitude"), 3, 1e-3);
  EXPECT_EQ(fact(free_of_damping, "swing.2.amplitude_error"), "none");
  run.oscillator.damping = 0.5;
  run.oscillator.cubic = 1;
  EXPECT_EQ(fact(collected(run), "swing.2.exact.amplitude"), "none");
  run.drive.frequency = 0;
  EXPECT_EQ(fact(collected(run), "swing.2.steady.amplitude"), "none");
  run = driven_run();
  run.trajectory.t.resize(30);  // less than a cycle
  run.trajectory.x.resize(30);
  run.trajectory.v.resize(30);
  EXPECT_EQ(fact(collected(run), "swing.2.steady.amplitude"), "none");
  EXPECT_NE(fact(collected(run), "swing.2.exact.amplitude"), "none");
}

TEST(CollectSimulate, SaysWhatGetsThrough) {
  SimulatedRun run = driven_run();
  run.transmission = RunTransmission{.sent = 4, .exact = {0.5, 0.75}};
  Results results = collected(run);
  EXPECT_EQ(fact(results, "swing.2.transmissibility.ratio"), "0.5");
  EXPECT_EQ(fact(results, "swing.2.transmissibility.phase_lag"), "0.75 rad");
  EXPECT_EQ(fact(results, "swing.2.transmissibility.transmitted"), "2 N");
  EXPECT_EQ(fact(results, "swing.2.transmissibility.simulated.ratio"), "none");
  EXPECT_EQ(fact(results, "swing.2.transmissibility.simulated.error"), "none");
  run.transmission->of_motion = true;
  run.transmission->simulated = Transmission{0.75, 1};
  results = collected(run);
  EXPECT_EQ(fact(results, "swing.2.transmissibility.transmitted"), "2 m");
  EXPECT_EQ(fact(results, "swing.2.transmissibility.simulated.ratio"), "0.75");
  EXPECT_EQ(fact(results, "swing.2.transmissibility.simulated.error"), "0.5");
  run.transmission->exact.amplitude = HUGE_VAL;
  EXPECT_TRUE(std::isnan(value(collected(run), "swing.2.transmissibility.ratio")));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
