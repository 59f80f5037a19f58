// What happens inside a step, on paths that are polynomials of theta.
#include "cromer/run/look_inside.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace cromer::core {
namespace {

using Path = std::function<State<double>(double)>;
constexpr auto position = Event::Quantity::position;

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

}  // namespace
}  // namespace cromer::core
