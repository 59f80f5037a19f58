#include "cromer/run/solve.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "cromer/methods/all.h"
#include "cromer/model/driven_oscillator.h"

namespace cromer {
namespace {

const Oscillator<double> spring{.mass = 1, .stiffness = 9};
const HarmonicDrive<double> push{.amplitude = 1, .frequency = 3};

/// The two lines of solve.h, for the spring alone.
Outcome simulate(const HarmonicDrive<double>& drive, std::string_view name, Interval interval,
                 State<double> start, double step, KeepEvery& keep, const Watch& watch = {}) {
  const auto by_name = [&](const auto& system) {
    return visit_method(name, {}, [&](const auto& method) {
      return solve(system, method, interval, start, step, keep, watch);
    });
  };
  if (drive.amplitude == 0) return by_name(DrivenOscillator<double, Terms{}>(spring, {}));
  return by_name(DrivenOscillator<double, Terms{.drive = true}>(spring, force_of(drive, spring.mass)));
}

struct Run {
  Outcome outcome;
  Trajectory trajectory;
};

Run run(const HarmonicDrive<double>& drive, std::string_view name, double until, double step,
        long long every = 1, State<double> start = {1, 0}) {
  KeepEvery keep(every, count_steps({0, until}, step));
  const Outcome outcome = simulate(drive, name, {0, until}, start, step, keep);
  return {outcome, keep.take()};
}

TEST(Solve, KeepsTheStartAndEveryStateAtItsTime) {
  const auto [outcome, kept] = run(push, "euler-cromer", 50, 0.01);
  EXPECT_EQ(outcome.status, Status::reached_end);
  EXPECT_EQ(outcome.step, 5000);
  EXPECT_EQ(outcome.counts.accepted, 5000);
  EXPECT_EQ(outcome.counts.evaluations, 5000);
  EXPECT_EQ(outcome.last_step, 0);
  ASSERT_EQ(kept.size(), 5001u);
  for (std::size_t n = 0; n < kept.size(); ++n) EXPECT_EQ(kept.t[n], static_cast<double>(n) * 0.01);
  EXPECT_EQ(kept.x.front(), 1);
  EXPECT_EQ(kept.x.back(), outcome.y.x);
  EXPECT_EQ(kept.v.back(), outcome.y.v);
}

TEST(Solve, EveryNthStateIsOneOfAll) {
  const auto all = run(push, "rk4", 10, 0.01).trajectory;
  const auto [outcome, some] = run(push, "rk4", 10, 0.01, 7);
  ASSERT_EQ(some.size(), 1000u / 7 + 1);
  for (std::size_t i = 0; i < some.size(); ++i) {
    EXPECT_EQ(some.t[i], all.t[7 * i]);
    EXPECT_EQ(some.x[i], all.x[7 * i]);
  }
  EXPECT_EQ(outcome.y.x, all.x.back()) << "the final state is in the outcome, kept or not";
}

TEST(Solve, EndsWithOneShorterStepWhereStepsDoNotFit) {
  const auto [outcome, kept] = run(push, "exact", 1.005, 0.01);
  EXPECT_EQ(outcome.status, Status::reached_end);
  EXPECT_EQ(outcome.step, 101);
  EXPECT_NEAR(outcome.last_step, 0.005, 1e-15);
  EXPECT_NEAR(outcome.t, 1.005, 1e-15);
  EXPECT_NEAR(kept.t.back(), 1.005, 1e-15);
  const auto direct = run(push, "exact", 1.005, 1.005).outcome.y;
  EXPECT_NEAR(outcome.y.x, direct.x, 1e-15);
}

TEST(Solve, AShorterStepThanAskedForIsStillAStep) {
  const auto [outcome, kept] = run({}, "rk4", 0.004, 0.01);
  EXPECT_EQ(outcome.step, 1);
  EXPECT_EQ(outcome.last_step, 0.004);
  EXPECT_NEAR(outcome.y.x, std::cos(0.012), 1e-9);
}

TEST(Solve, TimesFollowTheStartOfTheInterval) {
  KeepEvery keep(1, count_steps({5, 6}, 0.1));
  const auto outcome = simulate(push, "verlet", {5, 6}, {1, 0}, 0.1, keep);
  const auto kept = keep.take();
  EXPECT_EQ(kept.t.front(), 5);
  EXPECT_EQ(outcome.t, 6);
  ASSERT_EQ(kept.size(), 11u);
}

TEST(Solve, ADivergingRunKeepsWhatWasFinite) {
  // Forward Euler, w h = 3: |rho|^2 = 10, out of range after about 620 steps.
  const auto [outcome, kept] = run({}, "forward-euler", 2000, 1);
  EXPECT_EQ(outcome.status, Status::not_finite);
  EXPECT_GT(outcome.step, 500);
  EXPECT_LT(outcome.step, 700);
  EXPECT_EQ(static_cast<long long>(kept.size()), outcome.step + 1);
  EXPECT_EQ(outcome.t, kept.t.back());
  EXPECT_EQ(outcome.y.x, kept.x.back());
  for (std::size_t i = 0; i < kept.size(); ++i)
    EXPECT_TRUE(std::isfinite(kept.x[i]) && std::isfinite(kept.v[i]));
}

TEST(Solve, AnInterruptStopsWithinAFewHundredSteps) {
  std::atomic<bool> interrupt = false;
  const Watch watch{.interrupt = &interrupt, .progress = {}};
  long long seen = 0;
  const auto stop_at_1000 = [&](double, const State<double>&) {
    if (++seen == 1000) interrupt = true;
  };
  const DrivenOscillator<double, Terms{}> system(spring, {});
  const auto outcome = solve(system, Rk4{}, {0, 1000}, State<double>{1, 0}, 0.01, stop_at_1000, watch);
  EXPECT_EQ(outcome.status, Status::stopped_by_event);
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_GE(outcome.step, 999);
  EXPECT_LT(outcome.step, 1500);
  EXPECT_EQ(outcome.step + 1, seen);
}

TEST(Solve, ProgressRisesToOne) {
  std::vector<double> told;
  Watch watch;
  watch.progress = [&](double fraction) { told.push_back(fraction); };
  KeepEvery keep(1000, count_steps({0, 1000}, 0.01));
  simulate(push, "euler-cromer", {0, 1000}, {1, 0}, 0.01, keep, watch);
  ASSERT_GT(told.size(), 5u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1.0);
}

TEST(Solve, TheStepLimitIsAStatus) {
  const DrivenOscillator<double, Terms{}> system(spring, {});
  const auto outcome =
      solve(system, Rk4{}, {0, 10}, State<double>{1, 0}, 0.01, KeepNone{}, {}, {.steps = 300});
  EXPECT_EQ(outcome.status, Status::step_limit);
  EXPECT_EQ(outcome.step, 300);
  EXPECT_DOUBLE_EQ(outcome.t, 3);
}

TEST(Solve, TermsChosenOrNotGiveTheSameMotion) {
  // A coefficient of zero that is computed, and one that is not.
  const DrivenOscillator<double, Terms{.drive = true, .law = law_of("viscous+drag+cubic")}> everything(spring, {1, 3, 0});
  const auto all = solve(everything, EulerCromer{}, {0, 80}, State<double>{0, 0}, 0.01, KeepNone{});
  const auto few = run(push, "euler-cromer", 80, 0.01, 1, {0, 0}).outcome;
  EXPECT_EQ(all.y, few.y);
}

TEST(Steps, WholeToABillionthOfAStep) {
  EXPECT_EQ(count_steps({0, 50}, 0.01).whole, 5000);
  EXPECT_EQ(count_steps({0, 50}, 0.01).last, 0);
  EXPECT_EQ(count_steps({0, 0.01 * (1 + 5e-10)}, 0.01).count(), 1);
  EXPECT_EQ(count_steps({0, 0.01 * (1 + 5e-9)}, 0.01).count(), 2);
  EXPECT_EQ(count_steps({0, 0.01 * (2 - 5e-10)}, 0.01).whole, 2);
  EXPECT_NEAR(count_steps({0, 1}, 0.3).last, 0.1, 1e-15);
  EXPECT_EQ(count_steps({2, 2}, 0.1).count(), 0);
}

TEST(Steps, ARunBeyondMemoryIsKnownBefore) {
  const auto steps = count_steps({0, 1e12}, 1e-6);
  EXPECT_GE(number_of_kept_states(steps, 1), 1'000'000'000'000'000LL);
  EXPECT_EQ(number_of_kept_states(count_steps({0, 10}, 0.1), 7), 15);
  EXPECT_GT(number_of_kept_states(count_steps({0, 1e300}, 1e-300), 1), 0) << "saturates, never wraps";
}

}  // namespace
}  // namespace cromer
