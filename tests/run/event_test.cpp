#include "cromer/run/event.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cromer/methods/all.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

namespace cromer {
namespace {

constexpr double pi = std::numbers::pi;
constexpr auto position = Event::Quantity::position;
constexpr auto velocity = Event::Quantity::velocity;

/// x = cos 3t, and what is found on it.
EventLog watch_for(std::vector<Event> events, std::string_view method, StepControl control,
                   Outcome* outcome = nullptr, Trajectory* trajectory = nullptr, double until = 10) {
  EventLog log{.events = std::move(events)};
  KeepEvery keep(1, count_steps({0, until}, control.step));
  const Oscillator<double> spring{.mass = 1, .stiffness = 9};
  const Outcome end = with_terms(spring, HarmonicDrive<double>{}, [&](const auto& system) {
    return visit_method(method, {}, [&](const auto& m) {
      return solve(system, m, {0, until}, State<double>{1, 0}, control, keep, {}, {}, &log);
    });
  });
  if (outcome) *outcome = end;
  if (trajectory) *trajectory = keep.take();
  return log;
}

TEST(Events, ZerosAndTurningPointsAreExactForTheExactMotion) {
  const auto log = watch_for({{position, 0}, {velocity, 0}}, "exact", 0.1);
  // Zeros at (n + 1/2) pi/3, turning points at n pi/3, n from 1: the start is none.
  ASSERT_EQ(log.found.size(), 19u);
  for (std::size_t i = 0; i < log.found.size(); ++i) {
    EXPECT_EQ(log.found[i].event, i % 2);
    EXPECT_NEAR(log.found[i].t, (static_cast<double>(i) + 1) * pi / 6, 1e-14);
    EXPECT_NEAR(log.found[i].event == 0 ? log.found[i].y.x : log.found[i].y.v, 0, 1e-14);
  }
}

TEST(Events, EveryMethodFindsThemToItsOwnAccuracy) {
  for (const MethodInfo& info : method_infos) {
    const auto log = watch_for({{velocity, 0}}, info.name, {0.01, 1e-11});
    ASSERT_EQ(log.found.size(), 9u) << info.name;
    const double tolerance = info.order == 1 ? 2e-2 : info.order == 2 ? 4e-3 : 1e-6;
    for (std::size_t i = 0; i < 9; ++i)
      EXPECT_NEAR(log.found[i].t, (static_cast<double>(i) + 1) * pi / 3, tolerance) << info.name;
  }
}

TEST(Events, RisingAndFallingAreTheirOwn) {
  const auto rising = watch_for({{position, 0.5, Crossing::rising}}, "exact", 0.1).found;
  const auto falling = watch_for({{position, 0.5, Crossing::falling}}, "exact", 0.1).found;
  ASSERT_EQ(rising.size(), 4u);
  ASSERT_EQ(falling.size(), 5u);
  EXPECT_NEAR(rising[0].t, 5 * pi / 9, 1e-14);
  EXPECT_NEAR(falling[0].t, pi / 9, 1e-14);
  EXPECT_GT(rising[0].y.v, 0);
  EXPECT_LT(falling[0].y.v, 0);
}

TEST(Events, BothPassagesWithinOneStepAreFound) {
  // x > 0.999 for 0.03 s about each turning point; steps of 0.1 s.
  const double late = 2 * pi / 3 - std::acos(0.999) / 3;
  for (const std::string_view method : {"exact", "dormand-prince"}) {
    const auto log = watch_for({{position, 0.999}}, method, {0.1, 1e-8});
    ASSERT_EQ(log.found.size(), 9u) << method;
    EXPECT_NEAR(log.found[1].t, late, 1e-5) << method;
    EXPECT_NEAR(log.found[2].t - late, 2 * std::acos(0.999) / 3, 1e-5) << method;
  }
}

TEST(Events, AStopEndsTheRunThere) {
  for (const std::string_view method : {"exact", "dormand-prince", "rk4"}) {
    Outcome outcome;
    Trajectory kept;
    const auto log = watch_for({{position, 0}, {velocity, 0, Crossing::rising, true}}, method, {0.1, 1e-13},
                               &outcome, &kept);
    EXPECT_EQ(outcome.status, Status::stopped_by_event) << method;
    EXPECT_FALSE(outcome.interrupted);
    const double tolerance = method == "rk4" ? 1e-3 : 1e-11;
    EXPECT_NEAR(outcome.t, pi / 3, tolerance) << method;
    EXPECT_NEAR(outcome.y.x, -1, tolerance) << method;
    ASSERT_EQ(log.found.size(), 2u) << method;
    EXPECT_EQ(log.found[1].event, 1u);
    ASSERT_EQ(kept.size(), 12u) << "0 to 1.0, and the event";
    EXPECT_EQ(kept.t.back(), outcome.t);
    EXPECT_EQ(kept.x.back(), outcome.y.x);
  }
}

TEST(Events, WatchingChangesNothing) {
  for (const MethodInfo& info : method_infos) {
    Outcome watched, alone;
    Trajectory seen, unseen;
    watch_for({{position, 0.3}}, info.name, 0.03, &watched, &seen, 10.01);
    watch_for({}, info.name, 0.03, &alone, &unseen, 10.01);
    EXPECT_EQ(watched.y, alone.y) << info.name;
    EXPECT_EQ(watched.last_step, alone.last_step) << info.name;
    EXPECT_EQ(seen.t, unseen.t) << info.name;
    EXPECT_EQ(seen.x, unseen.x) << info.name;
  }
}

TEST(Events, PassedIsASignThatChanges) {
  const Event any{velocity, 0}, rising{velocity, 0, Crossing::rising};
  EXPECT_TRUE(any.passed(-1, 1));
  EXPECT_TRUE(any.passed(1, 0)) << "arriving counts";
  EXPECT_FALSE(any.passed(0, 1)) << "leaving does not: it has been counted";
  EXPECT_FALSE(any.passed(1, 2));
  EXPECT_TRUE(rising.passed(-1, 1));
  EXPECT_FALSE(rising.passed(1, -1));
}

}  // namespace
}  // namespace cromer
