// Phases of a mass with dry friction, one by one.
#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <utility>
#include <vector>

#include "cromer/methods/all.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/friction.h"
#include "cromer/model/general_drive.h"
#include "cromer/run/solve.h"
#include "cromer/run/stick_slip.h"

namespace cromer::core {
namespace CROMER_FILE {

using Spring = DrivenOscillator<double, Terms{}>;
const Oscillator<double> law{.mass = 1, .stiffness = 4};

TEST(DirectionFromRest, IsThatOfAPullBeyondWhatHolds) {
  const DryFriction system(Spring(law, {}), 1.0, 2.0);
  EXPECT_EQ(direction_from_rest(system, 0, 0.0), 0);
  EXPECT_EQ(direction_from_rest(system, 0, 0.5), 0) << "just what holds";
  EXPECT_EQ(direction_from_rest(system, 0, -0.5), 0);
  EXPECT_EQ(direction_from_rest(system, 0, 0.5001), -1);
  EXPECT_EQ(direction_from_rest(system, 0, -0.5001), 1);
}

struct Phases {
  std::vector<int> directions;
  std::vector<double> times;
  Course<double> course;
};

/// Phases of a second's slide each, after which the mass is at rest at the next of these places.
Phases phases(const State<double>& start, std::vector<double> places, double until) {
  const DryFriction system(Spring(law, {}), 1.0, 2.0);
  const Rows rows{{0, until}, 1};
  Phases seen{{}, {}, {0, start}};
  std::size_t n = 0;
  const auto slide = [&](int direction) {
    seen.directions.push_back(direction);
    seen.course.at_rest = true;
    seen.course.t += 1;
    ++seen.course.row;
    seen.course.y = {places.at(n++), 0};
  };
  const auto record = [&](double t, const State<double>& y) {
    seen.times.push_back(t);
    EXPECT_EQ(y.v, 0);
  };
  stick_and_slip(system, rows, seen.course, slide, record, {});
  return seen;
}

TEST(StickAndSlip, GoesOnAsTheVelocityOrThePullSays) {
  EXPECT_EQ(phases({0, 3}, {1, -1, 0.1}, 5).directions, (std::vector{1, -1, 1}));
  EXPECT_EQ(phases({0, -3}, {1, 0.1}, 5).directions, (std::vector{-1, -1}));
  EXPECT_EQ(phases({1, 0}, {0.1}, 5).directions, std::vector{-1});
  EXPECT_EQ(phases({-1, 0}, {0.1}, 5).directions, std::vector{1});
  EXPECT_TRUE(phases({0.1, 0}, {}, 5).directions.empty());
}

TEST(StickAndSlip, OfAMassThatSticksEveryRowIsRecorded) {
  const Phases seen = phases({1, 0}, {0.1}, 4.5);
  EXPECT_EQ(seen.times, (std::vector<double>{2, 3, 4, 4.5}));
  EXPECT_EQ(seen.course.t, 4.5);
  EXPECT_EQ(seen.course.row, 5);
  EXPECT_EQ(seen.course.y, (State<double>{0.1, 0}));
}

TEST(Stick, IsInterruptedAtTheStartAndNowAndThen) {
  std::atomic<bool> interrupt = true;
  const Watch watch{.interrupt = &interrupt, .progress = {}};
  const DryFriction system(Spring(law, {}), 1.0, 2.0);
  const Rows rows{{0, 1e5}, 1};
  long long recorded = 0;
  const auto interrupt_at_1500 = [&](double, const State<double>&) {
    if (++recorded == 1500) interrupt = true;
  };
  Course<double> course{0, {0.1, 0}};
  EXPECT_EQ(stick(system, rows, course, interrupt_at_1500, watch), 0);
  EXPECT_TRUE(course.interrupted);
  EXPECT_EQ(course.status, Status::stopped_by_event);
  EXPECT_EQ(recorded, 0);
  course = {0, {0.1, 0}};
  interrupt = false;
  EXPECT_EQ(stick(system, rows, course, interrupt_at_1500, watch), 0);
  EXPECT_TRUE(course.interrupted);
  EXPECT_GE(course.row, 1500);
  EXPECT_LT(course.row, 5000);
}

TEST(Stick, TheMassLosesWhatSpeedRoundingLeftIt) {
  const DryFriction system(Spring(law, {}), 1.0, 2.0);
  Course<double> course{0, {0.1, 1e-17}};
  KeepNone keep_none;
  EXPECT_EQ(stick(system, Rows{{0, 3}, 1}, course, keep_none, {}), 0);
  EXPECT_EQ(course.y, (State<double>{0.1, 0}));
  EXPECT_EQ(course.t, 3);
}

/// Fixed steps from 0 to 1 s in rows of 0.1 s, in phases that end at these times.
std::pair<Course<double>, std::vector<double>> in_phases(const std::vector<double>& ends) {
  const Spring system(law, {});
  const Rows rows{{0, 1}, 0.1};
  Course<double> course{0, {1, 0}};
  std::vector<double> times;
  const auto record = [&](double t, const State<double>&) { times.push_back(t); };
  for (const double end : ends) {
    StepperOf stepper(system, Rk4{}, course.t, course.y);
    take_fixed_steps(stepper, rows, {}, course, record, {}, {}, end);
  }
  return {course, times};
}

TEST(FixedSteps, APhaseEndsBetweenRowsOrOnOne) {
  const double infinite = std::numeric_limits<double>::infinity();
  const auto [whole, times] = in_phases({infinite});
  EXPECT_EQ(whole.counts.accepted, 10);
  EXPECT_EQ(whole.counts.evaluations, 40);
  ASSERT_EQ(times.size(), 10u);
  for (const auto& [ends, accepted] : {std::pair{std::vector{0.25, infinite}, 11LL},
                                       {std::vector{0.3, infinite}, 10LL},
                                       {std::vector{0.3 + 1e-12, infinite}, 10LL},
                                       {std::vector{0.3 - 1e-12, infinite}, 10LL},
                                       {std::vector{0.3 - 1e-6, infinite}, 11LL},
                                       {std::vector{0.25, 0.26, 0.75, infinite}, 13LL}}) {
    const auto [course, rows] = in_phases(ends);
    EXPECT_EQ(rows, times) << ends[0];
    EXPECT_EQ(course.counts.accepted, accepted) << ends[0];
    EXPECT_EQ(course.t, whole.t);
    EXPECT_NEAR(course.y.x, whole.y.x, 1e-5);
  }
  EXPECT_EQ(in_phases({0.25}).first.t, 0.25);
  EXPECT_EQ(in_phases({0.25}).first.row, 2);
  EXPECT_EQ(in_phases({0.25}).second.size(), 2u);
  EXPECT_EQ(in_phases({0.3 - 1e-12}).first.row, 3);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
