// Rows, what is kept of them, and where a run stands: by hand.
#include "cromer/run/course.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "cromer/run/course.h"
#include "cromer/run/event.h"
#include "cromer/run/keep.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(Steps, TheLastOneIsWhatIsLeft) {
  const Steps steps = count_steps({5, 7.75}, 0.5);
  EXPECT_EQ(steps.whole, 5);
  EXPECT_EQ(steps.last, 0.25);
  EXPECT_EQ(steps.count(), 6);
  const Steps whole = count_steps({-3, -1}, 0.5);
  EXPECT_EQ(whole.whole, 4);
  EXPECT_EQ(whole.last, 0);
  EXPECT_EQ(whole.count(), 4);
}

TEST(Steps, AnIntervalOfLessThanABillionthIsOneShortStep) {
  const Steps steps = count_steps({0, 1e-12}, 1);
  EXPECT_EQ(steps.whole, 0);
  EXPECT_EQ(steps.last, 1e-12);
  EXPECT_EQ(steps.count(), 1);
}

TEST(Steps, WithoutAnIntervalThereAreNone) {
  for (const Interval none : {Interval{2, 2}, {3, 2}}) {
    EXPECT_EQ(count_steps(none, 0.1).count(), 0);
    EXPECT_EQ(number_of_kept_states(count_steps(none, 0.1), 1), 1) << "the start";
  }
}

TEST(Steps, AreCountedUpToWhereTimesCannotBeToldApart) {
  constexpr long long most = 1LL << 53;
  const auto whole = [](double until) { return count_steps({0, until}, 1).whole; };
  EXPECT_EQ(whole(static_cast<double>(most) - 1), most - 1);
  EXPECT_EQ(whole(static_cast<double>(most)), most);
  EXPECT_EQ(whole(static_cast<double>(most) * 2), most);
  EXPECT_EQ(count_steps({0, 1e300}, 1e-300).count(), most);
  // A million and a half of rounding of the quotient is none of the run.
  const Steps many = count_steps({0, 0.1 * 12345678901}, 0.1);
  EXPECT_EQ(many.count(), 12345678901);
}

TEST(Steps, KeptStatesAreEveryNthAndTheFirst) {
  const auto kept = [](double until, long long every) {
    return number_of_kept_states(count_steps({0, until}, 1), every);
  };
  EXPECT_EQ(kept(10, 1), 11);
  EXPECT_EQ(kept(10, 5), 3);
  EXPECT_EQ(kept(9.5, 5), 3);
  EXPECT_EQ(kept(9, 5), 2);
  EXPECT_EQ(kept(3, 5), 1);
}

TEST(Rows, AreAtTheirTimes) {
  const Rows rows{{5, 6.25}, 0.5};
  EXPECT_EQ(rows.last(), 3);
  const double times[] = {5, 5.5, 6, 6.25}, spacings[] = {0.5, 0.5, 0.25};
  for (int n = 0; n < 4; ++n) EXPECT_EQ(rows.time(n), times[n]) << n;
  for (int n = 0; n < 3; ++n) EXPECT_EQ(rows.spacing(n), spacings[n]) << n;
}

TEST(Course, EndsAtTheLastRowOrBefore) {
  const Rows rows{{0, 3}, 1};
  Course<double> course{0, {}};
  EXPECT_TRUE(course.goes_on(rows));
  course.row = 2;
  EXPECT_TRUE(course.goes_on(rows));
  course.status = Status::not_finite;
  EXPECT_FALSE(course.goes_on(rows));
  course.status = Status::reached_end;
  course.row = 3;
  EXPECT_FALSE(course.goes_on(rows));
}

TEST(Course, SaysHowItEnded) {
  const Rows rows{{0, 2.25}, 1};
  Course<double> course{.t = 2.25, .y = {3, 4}, .row = 3};
  course.counts = {.accepted = 7, .rejected = 2, .evaluations = 9, .newton_iterations = 1};
  std::vector<double> told;
  Watch watch;
  watch.progress = [&](double part) { told.push_back(part); };
  const Outcome whole = course.outcome(rows, watch);
  EXPECT_EQ(whole.status, Status::reached_end);
  EXPECT_EQ(whole.t, 2.25);
  EXPECT_EQ(whole.y, (State<double>{3, 4}));
  EXPECT_EQ(whole.step, 7);
  EXPECT_EQ(whole.last_step, 0.25);
  EXPECT_EQ(whole.counts, course.counts);
  EXPECT_FALSE(whole.interrupted);
  EXPECT_EQ(told, std::vector<double>{1});
  course.status = Status::step_limit;
  EXPECT_EQ(course.outcome(rows, watch).last_step, 0);
  EXPECT_EQ(told.size(), 1u);
}

TEST(Course, LooksUpAtTheStartAndEveryHundredStepsOrSo) {
  std::atomic<bool> interrupt = true;
  const Watch watch{.interrupt = &interrupt, .progress = {}};
  const Rows rows{{0, 1e4}, 1};
  const auto stops_at = [&](long long accepted, long long rejected) {
    Course<double> course{0, {}};
    course.counts = {.accepted = accepted, .rejected = rejected};
    course.look_up(rows, watch, {});
    EXPECT_EQ(course.interrupted, course.status == Status::stopped_by_event);
    return course.interrupted;
  };
  EXPECT_TRUE(stops_at(0, 0));
  EXPECT_FALSE(stops_at(1, 0));
  int seen = 0, seen_of_rejected = 0;
  for (int n = 0; n < 2000; ++n) {
    seen += stops_at(n, 0);
    seen_of_rejected += stops_at(5, n);
  }
  EXPECT_GE(seen, 10);
  EXPECT_LE(seen, 25);
  EXPECT_GE(seen_of_rejected, 10);
  EXPECT_LE(seen_of_rejected, 25);
}

TEST(Course, TheLimitIsOnAcceptedSteps) {
  const Rows rows{{0, 1e4}, 1};
  const auto after = [&](long long accepted) {
    Course<double> course{0, {}};
    course.counts = {.accepted = accepted, .rejected = 100};
    course.look_up(rows, {}, {.steps = 10});
    return course.status;
  };
  EXPECT_EQ(after(9), Status::reached_end);
  EXPECT_EQ(after(10), Status::step_limit);
}

TEST(Course, TellsHowFarItIs) {
  const Rows rows{{0, 200}, 1};
  std::vector<double> told;
  Watch watch;
  watch.progress = [&](double part) { told.push_back(part); };
  Course<double> course{0, {}};
  course.row = 50;
  for (int n = 0; n < 20000; ++n) {
    course.counts.accepted = n;
    course.look_up(rows, watch, {});
  }
  EXPECT_GE(told.size(), 2u);
  EXPECT_LE(told.size(), 10u);
  for (const double part : told) EXPECT_EQ(part, 0.25);
}

TEST(Course, BothNumbersOfAStateMustBeFinite) {
  constexpr double infinite = std::numeric_limits<double>::infinity(),
                   most = std::numeric_limits<double>::max();
  EXPECT_TRUE(is_finite(State<double>{most, 0}));
  EXPECT_TRUE(is_finite(State<double>{0, -most}));
  EXPECT_TRUE(is_finite(State<double>{-most, -most}));
  for (const double bad : {infinite, -infinite, std::nan("")}) {
    EXPECT_FALSE(is_finite(State<double>{bad, 1}));
    EXPECT_FALSE(is_finite(State<double>{1, bad}));
    EXPECT_FALSE(is_finite(State<double>{bad, bad}));
  }
}

TEST(Outcome, EveryStatusHasItsName) {
  EXPECT_EQ(name(Status::reached_end), "reached_end");
  EXPECT_EQ(name(Status::stopped_by_event), "stopped_by_event");
  EXPECT_EQ(name(Status::step_limit), "step_limit");
  EXPECT_EQ(name(Status::step_too_small), "step_too_small");
  EXPECT_EQ(name(Status::no_convergence), "no_convergence");
  EXPECT_EQ(name(Status::not_finite), "not_finite");
}

TEST(KeepEvery, KeepsTheFirstAndEveryThirdAfterIt) {
  KeepEvery keep(3, {.whole = 8});
  for (int run = 0; run < 2; ++run) {
    for (int n = 0; n < 9; ++n) keep(10 + n, {20.0 + n, 30.0 + n});
    if (run == 0) keep.clear();
  }
  keep.pause();
  const Trajectory kept = keep.take();
  EXPECT_EQ(kept.t, (std::vector<double>{10, 13, 16}));
  EXPECT_EQ(kept.x, (std::vector<double>{20, 23, 26}));
  EXPECT_EQ(kept.v, (std::vector<double>{30, 33, 36}));
}

TEST(KeepEvery, ALongRunGetsItsRoomBitByBit) {
  constexpr long long steps = 200'000;
  KeepEvery keep(1, {.whole = steps});
  for (long long n = 0; n <= steps; ++n) {
    keep(static_cast<double>(n), {-static_cast<double>(n), 1});
    if (n % 255 == 0) keep.pause();
  }
  const Trajectory kept = keep.take();
  ASSERT_EQ(kept.size(), 200'001u);
  for (std::size_t n = 0; n < kept.size(); ++n) ASSERT_EQ(kept.x[n], -kept.t[n]);
  EXPECT_EQ(kept.t.back(), 200'000);
}

TEST(KeepEvery, OfARunThatEndedEarlyKeepsWhatThereIs) {
  KeepEvery keep(1, {.whole = 8});
  for (int n = 0; n < 3; ++n) keep(n, {});
  EXPECT_EQ(keep.take().size(), 3u);
}

TEST(EventLog, CountsWhatItNoLongerKeeps) {
  EventLog log;
  for (long long i = 0; i < EventLog::most; ++i) log.add({});
  EXPECT_EQ(log.missed, 0);
  for (int i = 0; i < 3; ++i) log.add({});
  EXPECT_EQ(log.missed, 3);
  EXPECT_EQ(static_cast<long long>(log.found.size()), EventLog::most);
}

TEST(Event, DistanceIsFromTheValue) {
  const Event place{.quantity = Event::Quantity::position, .value = 3}, speed{.value = -2};
  EXPECT_EQ(place.distance({5, 7}), 2);
  EXPECT_EQ(speed.distance({5, 7}), 9);
  const Event falling{.crossing = Crossing::falling};
  EXPECT_TRUE(falling.passed(1, -1));
  EXPECT_TRUE(falling.passed(1, 0));
  EXPECT_FALSE(falling.passed(-1, 1));
  EXPECT_FALSE(falling.passed(-1, 0));
  EXPECT_FALSE(falling.passed(-1, -2));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
