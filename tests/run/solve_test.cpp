#include "cromer/run/solve.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <vector>

#include "cromer/methods/all.h"
#include "cromer/model/driven_oscillator.h"

namespace cromer::core {
namespace CROMER_FILE {

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
  const DrivenOscillator<double, Terms{.drive = true, .law = law_of("viscous+drag+cubic")}> everything(
      spring, {1, 3, 0});
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

/// Ten steps and a half.
Outcome limited(long long steps) {
  const DrivenOscillator<double, Terms{}> system(spring, {});
  return solve(system, Rk4{}, {5, 6.05}, State<double>{1, 0}, 0.1, KeepNone{}, {}, {.steps = steps});
}

TEST(Solve, TheLimitCountsTheShorterStepToo) {
  EXPECT_EQ(limited(9).status, Status::step_limit);
  EXPECT_EQ(limited(9).step, 9);
  EXPECT_EQ(limited(10).status, Status::step_limit);
  EXPECT_EQ(limited(10).step, 10);
  EXPECT_EQ(limited(10).last_step, 0);
  EXPECT_DOUBLE_EQ(limited(10).t, 6);
  EXPECT_EQ(limited(11).status, Status::reached_end);
  EXPECT_EQ(limited(11).step, 11);
  EXPECT_NEAR(limited(11).last_step, 0.05, 1e-15);
  EXPECT_DOUBLE_EQ(limited(11).t, 6.05);
  EXPECT_EQ(limited(11).counts.evaluations, 44);
  const DrivenOscillator<double, Terms{}> system(spring, {});
  EXPECT_EQ(solve(system, Rk4{}, {5, 6}, State<double>{1, 0}, 0.1, KeepNone{}, {}, {.steps = 10}).status,
            Status::reached_end);
}

TEST(Solve, ALoopThatIsWatchedSaysTheSame) {
  const DrivenOscillator<double, Terms{}> system(spring, {});
  for (const double until : {6.0, 6.05})
    for (const long long limit : {9LL, 10LL, 11LL, 12LL}) {
      EventLog log{.events = {{.quantity = Event::Quantity::position, .value = 5}}};
      const auto by = [&](EventLog* events) {
        std::vector<double> times;
        const auto see = [&](double t, const State<double>&) { times.push_back(t); };
        const Outcome outcome =
            solve(system, Rk4{}, {5, until}, State<double>{1, 0}, 0.1, see, {}, {.steps = limit}, events);
        EXPECT_EQ(times.size(), static_cast<std::size_t>(outcome.step) + 1);
        return outcome;
      };
      const Outcome fast = by(nullptr), watched = by(&log);
      EXPECT_EQ(watched.status, fast.status) << until << ' ' << limit;
      EXPECT_EQ(watched.step, fast.step);
      EXPECT_EQ(watched.last_step, fast.last_step);
      EXPECT_EQ(watched.t, fast.t);
      EXPECT_EQ(watched.y, fast.y);
    }
}

TEST(Solve, NoIntervalIsNoStep) {
  std::vector<double> times;
  const DrivenOscillator<double, Terms{}> system(spring, {});
  const auto see = [&](double t, const State<double>&) { times.push_back(t); };
  const Outcome outcome = solve(system, Rk4{}, {5, 5}, State<double>{1, 2}, 0.1, see);
  EXPECT_EQ(outcome.status, Status::reached_end);
  EXPECT_EQ(outcome.step, 0);
  EXPECT_EQ(outcome.t, 5);
  EXPECT_EQ(outcome.y, (State<double>{1, 2}));
  EXPECT_EQ(times, std::vector<double>{5});
}

TEST(Solve, AStepWithoutASolutionEndsTheRun) {
  // One iteration is too few for a drag: in whole steps, in the shorter one, and where events are watched
  // for.
  const DrivenOscillator<double, Terms{.law = law_of("drag")}> rough({.mass = 1, .stiffness = 9, .drag = 5},
                                                                     {});
  const ImplicitEuler few{.newton = {.iteration_limit = 1}};
  EventLog log{.events = {{.quantity = Event::Quantity::position, .value = 5}}};
  for (const Interval interval : {Interval{0, 1}, {0, 0.05}})
    for (EventLog* events : {static_cast<EventLog*>(nullptr), &log}) {
      const auto outcome = solve(rough, few, interval, State<double>{1, 3}, 0.1, KeepNone{}, {}, {}, events);
      EXPECT_EQ(outcome.status, Status::no_convergence);
      EXPECT_EQ(outcome.step, 0);
      EXPECT_EQ(outcome.t, 0);
      EXPECT_EQ(outcome.y, (State<double>{1, 3}));
      EXPECT_EQ(outcome.last_step, 0);
      EXPECT_EQ(outcome.counts.newton_iterations, 1);
    }
}

TEST(Solve, AStateThatIsNotFiniteEndsTheRun) {
  const DrivenOscillator<double, Terms{}> system({.mass = 1, .stiffness = 1e300}, {});
  EventLog log{.events = {{.quantity = Event::Quantity::position, .value = 5}}};
  for (const Interval interval : {Interval{0, 1}, {0, 0.05}})
    for (EventLog* events : {static_cast<EventLog*>(nullptr), &log}) {
      const auto outcome =
          solve(system, ForwardEuler{}, interval, State<double>{1e20, 3}, 0.1, KeepNone{}, {}, {}, events);
      EXPECT_EQ(outcome.status, Status::not_finite);
      EXPECT_EQ(outcome.step, 0);
      EXPECT_EQ(outcome.y, (State<double>{1e20, 3}));
    }
}

TEST(Solve, ProgressIsThePartOfTheStepsThatWasTaken) {
  // Told after some thousands of steps each.
  std::vector<double> told;
  std::vector<long long> taken;
  long long seen = -1;
  Watch watch;
  watch.progress = [&](double part) {
    told.push_back(part);
    taken.push_back(seen);
  };
  const DrivenOscillator<double, Terms{}> system(spring, {});
  const auto see = [&](double, const State<double>&) { ++seen; };
  EventLog log{.events = {{.quantity = Event::Quantity::position, .value = 5}}};
  for (EventLog* events : {static_cast<EventLog*>(nullptr), &log}) {
    told.clear();
    taken.clear();
    seen = -1;
    solve(system, Rk4{}, {0, 300.005}, State<double>{1, 0}, 0.01, see, watch, {}, events);
    ASSERT_GE(told.size(), 4u);
    ASSERT_LE(told.size(), 30u);
    for (std::size_t i = 0; i < told.size(); ++i)
      EXPECT_NEAR(told[i], static_cast<double>(taken[i]) / 30001, 1e-12) << i;
    EXPECT_EQ(told.front(), 0);
    EXPECT_EQ(told.back(), 1);
  }
}

TEST(Solve, AWatchedRunIsInterruptedWithinAFewHundredSteps) {
  std::atomic<bool> interrupt = false;
  const Watch watch{.interrupt = &interrupt, .progress = {}};
  long long seen = 0;
  const auto stop_at_1000 = [&](double, const State<double>&) {
    if (++seen == 1000) interrupt = true;
  };
  EventLog log{.events = {{.quantity = Event::Quantity::position, .value = 5}}};
  const DrivenOscillator<double, Terms{}> system(spring, {});
  const auto outcome =
      solve(system, Rk4{}, {0, 1000}, State<double>{1, 0}, 0.01, stop_at_1000, watch, {}, &log);
  EXPECT_EQ(outcome.status, Status::stopped_by_event);
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_GE(outcome.step, 999);
  EXPECT_LT(outcome.step, 1500);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
