#include "cromer/tasks/simulate/simulate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "cromer/methods/all.h"
#include "cromer/tasks/simulate/early_end.h"
#include "cromer/tasks/simulate/laid_over.h"
#include "cromer/tasks/simulate/simulate_setup.h"
#include "tests/support/simulated.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::HasSubstr;

TEST(Simulate, DefaultsAreThoseOfTheContract) {
  const auto result = simulated({});
  ASSERT_EQ(result.runs.size(), 1u);
  const auto& only = result.runs.front();
  EXPECT_EQ(only.method, "euler-cromer");
  EXPECT_DOUBLE_EQ(only.step, two_pi / 200);
  EXPECT_DOUBLE_EQ(only.until, 20 * two_pi);
  EXPECT_EQ(only.start, (State<double>{1, 0}));
  EXPECT_EQ(only.outcome.status, Status::reached_end);
  EXPECT_EQ(only.trajectory.size(), 4001u);
}

TEST(Simulate, AMotionThatIsSetGoingStartsAtRestAtZero) {
  EXPECT_EQ(simulated({.velocity = 2}).runs.front().start, (State<double>{0, 2}));
  EXPECT_EQ(simulated({.drive_amplitude = 1, .drive_frequency = {3}}).runs.front().start,
            (State<double>{0, 0}));
}

TEST(Simulate, TheShorterPeriodSetsTheStep) {
  const auto result = simulated({.stiffness = 9, .drive_amplitude = 1, .drive_frequency = {1, 10}});
  EXPECT_DOUBLE_EQ(result.runs[0].step, two_pi / 3 / 200);
  EXPECT_DOUBLE_EQ(result.runs[1].step, two_pi / 10 / 200);
  EXPECT_DOUBLE_EQ(result.runs[1].until, 20 * two_pi / 3);
}

TEST(Simulate, FrequencyAndRatioSetSpringAndDamping) {
  const Oscillator<double> law =
      simulated({.mass = 0.5, .natural_frequency = 6, .damping_ratio = 0.1}).runs.front().oscillator;
  EXPECT_DOUBLE_EQ(law.stiffness, 18);
  EXPECT_DOUBLE_EQ(law.damping, 2 * 0.1 * std::sqrt(18 * 0.5));
  EXPECT_DOUBLE_EQ(simulated({.stiffness = 9, .quality_factor = 15}).runs.front().oscillator.damping, 0.2);
}

TEST(Simulate, AgreesWithTheClosedForm) {
  // x = exp(-b t)(cos wd t + b/wd sin wd t), b = 0.1, w = 3.
  SimulateOptions options{
      .stiffness = 9, .damping = 0.2, .method = {"exact", "rk4"}, .step = 0.01, .until = 10};
  const auto result = simulated(options);
  const double wd = std::sqrt(9 - 0.01);
  for (std::size_t i = 0; i < result.runs[0].trajectory.size(); ++i) {
    const double t = result.runs[0].trajectory.t[i];
    const double truth = std::exp(-0.1 * t) * (std::cos(wd * t) + 0.1 / wd * std::sin(wd * t));
    EXPECT_NEAR(result.runs[0].trajectory.x[i], truth, 1e-13);
    EXPECT_NEAR(result.runs[1].trajectory.x[i], truth, 1e-6);
  }
}

TEST(Simulate, EveryMethodRunsInTheOrderAsked) {
  SimulateOptions options{.drive_amplitude = 1, .drive_frequency = {2, 0.5}, .step = 0.05, .until = 1};
  for (const auto name : method_names) options.method.emplace_back(name);
  const auto result = simulated(options);
  ASSERT_EQ(result.runs.size(), 2 * method_names.size());
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    EXPECT_EQ(result.runs[i].method, method_names[i / 2]);
    EXPECT_EQ(result.runs[i].drive.frequency, i % 2 ? 0.5 : 2);
    EXPECT_TRUE(result.ok());
  }
}

TEST(Simulate, KeepsEveryNthState) {
  const auto result = simulated({.step = 0.01, .until = 1, .every = 10});
  ASSERT_EQ(result.runs.front().trajectory.size(), 11u);
  EXPECT_DOUBLE_EQ(result.runs.front().trajectory.t[3], 0.3);
}

TEST(Simulate, RefusesWhatHasNoMeaning) {
  EXPECT_THAT(refusal({.mass = 0}), HasSubstr("--mass"));
  EXPECT_THAT(refusal({.mass = std::nan("")}), HasSubstr("--mass"));
  EXPECT_THAT(refusal({.damping = std::nan("")}), HasSubstr("--damping"));
  EXPECT_THAT(refusal({.step = -0.1}), HasSubstr("--step"));
  EXPECT_THAT(refusal({.method = {"rk5"}}), HasSubstr("rk4"));
  EXPECT_THAT(refusal({.law = {.drag = 1}, .method = {"exact"}}), HasSubstr("drag (1 kg/m)"));
  EXPECT_THAT(refusal({.stiffness = -1, .damping_ratio = 0.1}), HasSubstr("--damping-ratio"));
  EXPECT_THAT(refusal({.stiffness = 0}), HasSubstr("no natural period"));
  EXPECT_THAT(refusal({.position = 1e200}), HasSubstr("--position"));
}

TEST(Simulate, RefusesMoreStatesThanMemoryBeforeTakingIt) {
  EXPECT_THAT(refusal({.step = 1e-3, .until = 1e3, .memory = 1e6}), HasSubstr("24 MB"));
  EXPECT_EQ(refusal({.step = 1e-3, .until = 1e3, .every = 1000, .memory = 1e6}), "");
  EXPECT_NE(refusal({.step = 1e-9, .until = 1e9}), "");
}

TEST(Simulate, ADoubleWellHasThePeriodOfItsBottom) {
  // k = -1, k3 = 1: wells at x = +-1 with stiffness 2.
  EXPECT_DOUBLE_EQ(natural_period({.stiffness = -1, .cubic = 1}), two_pi / std::sqrt(2));
  EXPECT_EQ(natural_period({.stiffness = -1}), 0);
  const auto result = simulated({.stiffness = -1, .law = {.cubic = 1}, .position = 1.001, .method = {"rk4"}});
  const auto& x = result.runs.front().trajectory.x;
  EXPECT_NEAR(x[200], x[0], 1e-6);
}

TEST(Simulate, SaysWhenARunDivergedAndEndsFinite) {
  const auto result = simulated({.method = {"forward-euler"}, .step = 1, .until = 1e5});
  const auto& only = result.runs.front();
  EXPECT_FALSE(result.ok());
  EXPECT_EQ(only.outcome.status, Status::not_finite);
  // The energy doubles each step, E = 2^(n-1); doubles end below 2^1024.
  EXPECT_EQ(only.outcome.step, 1024);
  EXPECT_THAT(in_words(only.message), HasSubstr("diverged: not finite after t = 1024 s (step 1024)"));
  EXPECT_EQ(only.trajectory.t.back(), only.outcome.t);
}

TEST(Simulate, WarnsOfWhatHasNoEffect) {
  const auto warnings = [](const SimulateOptions& options) {
    std::string all;
    for (const auto& warning : in_words(simulated(options).notices)) all += warning + "\n";
    return all;
  };
  EXPECT_EQ(warnings({}), "");
  EXPECT_EQ(warnings({.law = {.friction = 0.1}}), "");
  EXPECT_THAT(warnings({.method = {"rk4"}, .tolerance = 1e-9}), HasSubstr("no effect on rk4"));
  EXPECT_EQ(warnings({.method = {"implicit-euler"}, .tolerance = 1e-9}), "");
  EXPECT_THAT(warnings({.drive_frequency = {3}}), HasSubstr("--drive-amplitude"));
  EXPECT_THAT(warnings({.step = 0.01, .until = 0.105}), HasSubstr("the last step is 0.005 s"));
}

TEST(Simulate, AnInterruptKeepsWhatIsThere) {
  std::atomic<bool> stop{true};
  const auto result = simulate({.step = 0.01, .until = 1e6, .every = 1000}, {&stop, {}});
  ASSERT_TRUE(result.ok());
  EXPECT_FALSE(result->ok());
  EXPECT_TRUE(result->runs.front().outcome.interrupted);
  EXPECT_THAT(in_words(result->runs.front().message), HasSubstr("interrupted after t = "));
  EXPECT_GE(result->runs.front().trajectory.size(), 1u);
}

TEST(Simulate, ASensorReadsEveryKeptState) {
  SimulateOptions options{.step = 0.01, .until = 1, .every = 10};
  options.sensor = {.noise = 0, .resolution = 1e-3, .offset = 0.2, .seed = 1, .used = true};
  const SimulatedRun only = simulated(options).runs.front();
  ASSERT_EQ(only.sensor.size(), only.trajectory.size());
  EXPECT_EQ(only.sensor.front(), 1.2);
  EXPECT_NEAR(only.sensor.back(), 0.2 + std::cos(1.0), 0.01);
}

TEST(EarlyEnd, SaysWhyWhenAndAtWhichStep) {
  const auto told = [](Status status, bool interrupted = false) {
    const Notice why =
        early_end({.status = status, .t = 1.5, .step = 30, .interrupted = interrupted, .counts = {}});
    return why.empty() ? "" : in_words(why);
  };
  EXPECT_EQ(told(Status::reached_end), "");
  EXPECT_EQ(told(Status::stopped_by_event), "");
  EXPECT_EQ(told(Status::stopped_by_event, true), "interrupted after t = 1.5 s (step 30)");
  EXPECT_EQ(told(Status::step_limit), "the step limit was reached at t = 1.5 s (step 30)");
  EXPECT_EQ(told(Status::step_too_small),
            "the step became too small to go on at t = 1.5 s (step 30): the motion runs away there, or "
            "--tolerance asks for too much");
  EXPECT_EQ(told(Status::no_convergence),
            "no convergence in Newton's iteration after t = 1.5 s (step 30); take a shorter --step");
  EXPECT_EQ(told(Status::not_finite), "diverged: not finite after t = 1.5 s (step 30)");
}

SimulatedRun kept_run(const std::vector<double>& t, const std::vector<double>& x) {
  SimulatedRun run;
  run.label = "rk4";
  run.until = t.back();
  run.trajectory.t = t;
  run.trajectory.x = x;
  run.trajectory.v.assign(t.size(), 0);
  return run;
}

TEST(LaidOver, TheDistanceIsThatFromTheLineThroughTheKeptStates) {
  const SimulatedRun run = kept_run({0, 1, 2}, {0, 2, 0});
  LaidOver samples{"x (m)", "m", {-0.5, 0, 0.5, 1.5, 2, 2.5}, {9, 0.1, 0.9, 1.1, -0.1, 9}};
  const auto told = [&] {
    const Notice notice = distance_notice(samples, run);
    return notice.empty() ? "" : in_words(notice);
  };
  EXPECT_EQ(told(), "rk4: the recording lies 10.0 cm (rms) from it, over 4 samples of x (m)");
  samples.unit = "rad";
  EXPECT_EQ(told(), "rk4: the recording lies 0.100 rad (rms) from it, over 4 samples of x (m)");
  samples.unit = "";
  EXPECT_EQ(told(), "rk4: the recording lies 0.100 (rms) from it, over 4 samples of x (m)");
  samples.t = {-1, -0.5, 2.01, 3, 4, 5};
  EXPECT_EQ(told(), "");
  EXPECT_TRUE(distance_notice(samples, kept_run({0}, {0})).empty());
  EXPECT_TRUE(distance_notice({"x", "m", {}, {}}, run).empty());
}

TEST(LaidOver, SamplesAreThoseWithinTheLongestRun) {
  const auto recording = read_recording(
      "Time (s),Position (m),Speed (m/s)\n1,0.1,1\n2,0.2,1\n3,0.3,1\n4,0.4,1\n5,0.5,1\n", "r.csv", {});
  SimulateResult runs;
  runs.runs = {kept_run({0, 2}, {0, 0}), kept_run({0, 1}, {0, 0})};
  const auto laid = lay_over(*recording, {.column = "Position", .from = 2.0, .offset = 0.05}, runs, {});
  ASSERT_TRUE(laid);
  EXPECT_EQ(laid->name, "Position (m)");
  EXPECT_EQ(laid->unit, "m");
  EXPECT_EQ(laid->t, (std::vector{0.0, 1.0, 2.0}));
  ASSERT_EQ(laid->x.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(laid->x[i], 0.15 + 0.1 * static_cast<double>(i));
  EXPECT_EQ(lay_over(*recording, {.column = "Position"}, runs, {})->x.size(), 3u);
  EXPECT_EQ(in_words(lay_over(*recording, {.column = "Position", .from = 5.5}, runs, {}).error()),
            "--over-from: column \"Position (m)\" has no sample from 5.5 to 7.5 s, where the runs are");
  EXPECT_EQ(in_words(lay_over(*recording, {.column = "Position", .from = -2.0}, runs, {}).error()),
            "--over-from: column \"Position (m)\" has no sample from -2 to 0 s, where the runs are");
  EXPECT_THAT(in_words(lay_over(*recording, {.column = "Speed"}, runs, {}).error()),
              HasSubstr("a run is laid over positions or angles, and column \"Speed (m/s)\" holds velocity"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
