#include "cromer/run/event.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "cromer/base/pi.h"
#include "cromer/methods/all.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr auto position = Event::Quantity::position;
constexpr auto velocity = Event::Quantity::velocity;

/// x = cos 3t, or from another start, and what is found on it.
EventLog watch_for(std::vector<Event> events, std::string_view method, StepControl control,
                   Outcome* outcome = nullptr, Trajectory* trajectory = nullptr, double until = 10,
                   State<double> start = {1, 0}) {
  EventLog log{.events = std::move(events)};
  KeepEvery keep(1, count_steps({0, until}, control.step));
  const DrivenOscillator<double, Terms{}> spring({.mass = 1, .stiffness = 9}, {});
  const Outcome end = visit_method(method, {}, [&](const auto& m) {
    return solve(spring, m, {0, until}, start, control, keep, {}, {}, &log);
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

/// The path of a method between its states, by its own partial steps: the quantity at `inside` times a step.
std::vector<double> path_of(Event::Quantity quantity, std::string_view name, State<double> y, double h,
                            int steps, int inside) {
  const DrivenOscillator<double, Terms{}> spring({.mass = 1, .stiffness = 9}, {});
  std::vector<double> path;
  const auto add = [&](const State<double>& at) { path.push_back(quantity == position ? at.x : at.v); };
  visit_method(name, {}, [&](const auto& method) {
    auto memory = method.start(spring, 0.0, y);
    for (int n = 0; n < steps; ++n) {
      for (int i = 1; i < inside; ++i) {
        auto copy = memory;
        add(method.step(spring, n * h, i * h / inside, y, copy).y);
      }
      y = method.step(spring, n * h, h, y, memory).y;
      add(y);
    }
    return 0;
  });
  return path;
}

/// x = -cos(3t + 0.13): the velocity is largest between two states.
const State<double> before_a_peak{-std::cos(0.13), 3 * std::sin(0.13)};

class ThresholdJustBelowThePeak : public testing::TestWithParam<std::string_view> {};

INSTANTIATE_TEST_SUITE_P(Registry, ThresholdJustBelowThePeak, testing::ValuesIn(method_names),
                         [](const auto& test) {
                           std::string name(test.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(ThresholdJustBelowThePeak, IsPassedTwice) {
  const MethodInfo& info = *find_method(GetParam());
  constexpr int inside = 1000;
  for (const auto quantity : {position, velocity})
    for (const int per_period : {20, 7}) {
      const double h = 2 * pi / 3 / per_period;
      const int steps = 6 * per_period / 7;
      const auto path = path_of(quantity, info.name, before_a_peak, h, steps, inside);
      const double peak = *std::max_element(path.begin(), path.end());
      const double threshold = peak - 1e-4 * peak;
      std::vector<double> passed;
      for (std::size_t i = 1; i < path.size(); ++i)
        if ((path[i] > threshold) != (path[i - 1] > threshold))
          passed.push_back((static_cast<double>(i) + 0.5) * h / inside);
      ASSERT_EQ(passed.size(), 2u) << per_period;
      const auto log = watch_for({{quantity, threshold}}, info.name, {h, 1e-11}, nullptr, nullptr, steps * h,
                                 before_a_peak);
      ASSERT_EQ(log.found.size(), 2u) << per_period;
      if (info.is_adaptive()) continue;  // it takes other steps
      for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(log.found[i].t, passed[i], h / inside) << per_period;
      // From order two on the path turns inside a step; Euler's runs straight.
      if (info.order != 1) {
        EXPECT_EQ(std::floor(log.found[0].t / h), std::floor(log.found[1].t / h)) << per_period;
      }
    }
}

TEST(Events, AThresholdBelowThePeakIsFoundToTheOrderOfTheMethod) {
  // 3 sin(3t + 0.13) = 2.7
  const double first = (std::asin(0.9) - 0.13) / 3, second = (pi - std::asin(0.9) - 0.13) / 3;
  for (const MethodInfo& info : method_infos) {
    const auto error = [&](int per_period) {
      const auto log = watch_for({{velocity, 2.7}}, info.name, {2 * pi / 3 / per_period, 1e-11}, nullptr,
                                 nullptr, pi / 3, before_a_peak);
      EXPECT_EQ(log.found.size(), 2u) << info.name << ' ' << per_period;
      if (log.found.size() < 2) return 1.0;
      return std::hypot(log.found[0].t - first, log.found[1].t - second);
    };
    if (!info.takes_fixed_steps()) {
      EXPECT_LT(error(7), info.is_exact() ? 1e-14 : 1e-10) << info.name;
      continue;
    }
    // So long a step leaves the first order no peak of this height.
    for (const int per_period : {20, 7})
      if (info.order > 1) {
        EXPECT_LT(3 * error(per_period), 0.6 * std::pow(2 * pi / per_period, info.order)) << info.name;
      }
    const int steps = info.order >= 4 ? 40 : 400;
    EXPECT_NEAR(std::log2(error(steps) / error(4 * steps)) / 2, info.order, 0.2) << info.name;
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

using Path = std::function<State<double>(double)>;

/// A step from 7 s to 7.5 s.
Cut look(int direction, EventLog* log, const Path& path, long long pieces = 1) {
  return look_inside({direction, log}, 7, 0.5, path(0), path(1), pieces, path, path);
}

std::vector<double> times(const EventLog& log) {
  std::vector<double> found;
  for (const FoundEvent& each : log.found) found.push_back((each.t - 7) / 0.5);
  return found;
}

void expect_times(const EventLog& log, const std::vector<double>& expected) {
  const std::vector<double> found = times(log);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-14);
}

TEST(LookInside, AStepOfWhichNothingIsAskedIsWhole) {
  const Cut cut = look(0, nullptr, [](double u) { return State<double>{u, 3 - 7 * u}; });
  EXPECT_EQ(cut.theta, 1);
  EXPECT_EQ(cut.y, (State<double>{1, -4}));
  EXPECT_FALSE(cut.at_rest || cut.stopped);
  EventLog empty;
  EXPECT_FALSE((Lookout{0, nullptr}.anything() || Lookout{0, &empty}.anything()));
  EXPECT_TRUE((Lookout{1, nullptr}.anything() && Lookout{-1, nullptr}.anything()));
  empty.events.push_back({});
  EXPECT_TRUE((Lookout{0, &empty}.anything()));
}

TEST(LookInside, WhatSlidesStopsWhereTheVelocityVanishes) {
  for (const int sign : {1, -1})
    for (const long long pieces : {1, 2, 3, 4, 7}) {
      const Cut cut = look(
          sign, nullptr,
          [&](double u) {
            return State<double>{sign * (u - u * u), sign * (1 - 2 * u)};
          },
          pieces);
      EXPECT_NEAR(cut.theta, 0.5, 1e-15) << pieces;
      EXPECT_NEAR(cut.y.x, sign * 0.25, 1e-15);
      EXPECT_EQ(cut.y.v, 0);
      EXPECT_TRUE(cut.at_rest);
      EXPECT_FALSE(cut.stopped);
    }
  const Cut goes_on = look(
      1, nullptr,
      [](double u) {
        return State<double>{u, 1 - u / 2};
      },
      3);
  EXPECT_FALSE(goes_on.at_rest);
  EXPECT_EQ(goes_on.theta, 1);
}

TEST(LookInside, AStopAtTheVeryEndIsOne) {
  const Cut cut = look(
      1, nullptr,
      [](double u) {
        return State<double>{u - u * u / 2, 1 - u};
      },
      2);
  EXPECT_TRUE(cut.at_rest);
  EXPECT_EQ(cut.theta, 1);
  EXPECT_EQ(cut.y, (State<double>{0.5, 0}));
}

TEST(LookInside, AMassThatBeginsAtRestMaySlideForAMomentOnly) {
  for (const double until : {0.6, 0.2, 0.01, 1e-5, 1e-8}) {
    const Cut cut = look(1, nullptr, [&](double u) {
      return State<double>{3 + until * u * u / 2 - u * u * u / 3, u * (until - u)};
    });
    EXPECT_TRUE(cut.at_rest) << until;
    EXPECT_NEAR(cut.theta, until, 1e-14) << until;
    EXPECT_EQ(cut.y.v, 0);
  }
}

TEST(LookInside, AMassThatDoesNotSlideStaysForTheStep) {
  for (const long long pieces : {1, 3}) {
    const Cut cut = look(
        1, nullptr,
        [](double u) {
          return State<double>{3 - u * u, -2 * u};
        },
        pieces);
    EXPECT_TRUE(cut.at_rest);
    EXPECT_EQ(cut.theta, 1);
    EXPECT_EQ(cut.y, (State<double>{3, 0}));
  }
}

TEST(LookInside, EventsAreInOrderOfTime) {
  const Path falling = [](double u) { return State<double>{1 - 2 * u, -2 + u}; };
  for (const long long pieces : {1, 2, 5}) {
    EventLog log{.events = {{.quantity = position, .value = -0.5},
                            {.quantity = position, .value = 0.5},
                            {.value = -1.7},
                            {.quantity = position, .value = 2}}};
    const Cut cut = look(0, &log, falling, pieces);
    EXPECT_FALSE(cut.stopped);
    EXPECT_EQ(cut.theta, 1);
    expect_times(log, {0.25, 0.3, 0.75});
    EXPECT_EQ(log.found[0].event, 1u);
    EXPECT_EQ(log.found[1].event, 2u);
    EXPECT_EQ(log.found[2].event, 0u);
    EXPECT_NEAR(log.found[2].y.v, -1.25, 1e-14);
  }
}

TEST(LookInside, NothingIsSeenAfterAStop) {
  const Path falling = [](double u) { return State<double>{1 - 2 * u, -2 + u}; };
  EventLog log{.events = {{.quantity = position, .value = -0.5},
                          {.quantity = position, .value = 0, .stop = true},
                          {.quantity = position, .value = 0.5}}};
  const Cut cut = look(0, &log, falling, 3);
  EXPECT_TRUE(cut.stopped);
  EXPECT_FALSE(cut.at_rest);
  EXPECT_NEAR(cut.theta, 0.5, 1e-15);
  EXPECT_NEAR(cut.y.v, -1.5, 1e-15);
  expect_times(log, {0.25, 0.5});
}

TEST(LookInside, OfASlideEventsCountUpToTheRest) {
  // x = u - u^2 comes to rest at 1/4, which the velocity's event sees as well.
  const Path path = [](double u) { return State<double>{u - u * u, 1 - 2 * u}; };
  EventLog log{.events = {{.quantity = position, .value = 0.16}, {.value = 0}}};
  const Cut cut = look(1, &log, path);
  EXPECT_TRUE(cut.at_rest);
  expect_times(log, {0.2, 0.5});
  EXPECT_EQ(log.found[1].y.v, 0);
  EventLog stops{.events = {{.value = 0, .stop = true}}};
  const Cut stopped = look(1, &stops, path);
  EXPECT_TRUE(stopped.stopped);
  EXPECT_EQ(stopped.y.v, 0) << "the state at rest, not the path's";
}

TEST(LookInside, APathThatTurnsPassesTwice) {
  for (const double sign : {1.0, -1.0})
    for (const double start : {0.0, -5.0}) {
      const Path path = [&](double u) {
        return State<double>{start + sign * u * (1 - u), sign * (1 - 2 * u)};
      };
      EventLog log{.events = {{.quantity = position, .value = start + sign * 0.21}}};
      look(0, &log, path);
      expect_times(log, {0.3, 0.7});
      EventLog rising{
          .events = {{.quantity = position, .value = start + sign * 0.21, .crossing = Crossing::rising}}};
      look(0, &rising, path);
      expect_times(rising, {sign > 0 ? 0.3 : 0.7});
      EventLog above{.events = {{.quantity = position, .value = start + sign * 0.26}}};
      look(0, &above, path);
      expect_times(above, {});
    }
}

TEST(LookInside, APathThatBeginsOnTheValueMayComeBackToIt) {
  const Path path = [](double u) { return State<double>{u * (0.4 - u), 0.4 - 2 * u}; };
  EventLog log{.events = {{.quantity = position, .value = 0}}};
  look(0, &log, path);
  expect_times(log, {0.4});
  EventLog leaves{.events = {{.quantity = position, .value = 0}}};
  look(0, &leaves, [](double u) { return State<double>{u, 1}; });
  expect_times(leaves, {});
}

TEST(LookInside, ATurnNearTheEndOfAPartIsSeenOfAnyPart) {
  // It turns a thousandth of the last of a hundred parts from the part's ends.
  for (const double turn : {0.99 + 1e-5, 1 - 1e-5}) {
    const double lift = 0.25e-10;
    const Path path = [&](double u) { return State<double>{-(u - turn) * (u - turn), -2 * (u - turn)}; };
    EventLog log{.events = {{.quantity = position, .value = -lift}}};
    look(0, &log, path, 100);
    ASSERT_EQ(log.found.size(), 2u) << turn;
    EXPECT_NEAR(times(log)[0], turn - 0.5e-5, 1e-9);
    EXPECT_NEAR(times(log)[1], turn + 0.5e-5, 1e-9);
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
