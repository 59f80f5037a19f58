// Times that repeat, run backward or start again; and the steps of times: rate, jitter, gaps.
#include "cromer/read/time.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <random>

#include "cromer/documents/words/words.h"

namespace cromer::core::dialects {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::IsEmpty;

/// first, first + 1, ...
std::vector<double> counted_from(double first, int count) {
  std::vector<double> t(static_cast<std::size_t>(count));
  std::iota(t.begin(), t.end(), first);
  return t;
}

std::vector<double> joined(std::vector<double> t, const std::vector<double>& more) {
  t.insert(t.end(), more.begin(), more.end());
  return t;
}

/// With line numbers from 11 on.
Result<RisingTimes> rising(const std::vector<double>& t) {
  std::vector<long> lines(t.size());
  std::iota(lines.begin(), lines.end(), 11);
  return keep_rising(t, lines);
}

TEST(Restart, NeedsMoreThanTenRowsBeforeIt) {
  EXPECT_THAT(restarts(joined(counted_from(0, 11), {0, 1, 2})), ElementsAre(11));
  EXPECT_THAT(restarts(joined(counted_from(0, 10), {0, 1, 2})), IsEmpty());
  // Each run is counted anew; repeated times are no rows.
  EXPECT_THAT(restarts(joined(joined(counted_from(0, 11), counted_from(0, 11)), {0, 1})),
              ElementsAre(11, 22));
  EXPECT_THAT(restarts(joined(joined(counted_from(0, 11), counted_from(0, 10)), {0, 1})), ElementsAre(11));
  EXPECT_THAT(restarts(joined(counted_from(0, 10), {9, 9, 0, 1, 2})), IsEmpty());
}

TEST(Restart, IsNearTheBeginning) {
  EXPECT_THAT(restarts(joined(counted_from(0, 21), {2, 3, 4})), ElementsAre(21));
  EXPECT_THAT(restarts(joined(counted_from(0, 21), {2.1, 3, 4})), IsEmpty());
  EXPECT_THAT(restarts(joined(counted_from(100, 21), {102, 103})), ElementsAre(21));
  EXPECT_THAT(restarts(joined(counted_from(100, 21), {102.1, 103})), IsEmpty());
  EXPECT_THAT(restarts(joined(counted_from(100, 21), {0, 1})), ElementsAre(21));
}

TEST(Restart, GoesOnForFiveRowsOrToTheEnd) {
  const std::vector<double> t = counted_from(0, 21);
  EXPECT_THAT(restarts(joined(t, {0})), IsEmpty());
  EXPECT_THAT(restarts(joined(t, {0, 1})), ElementsAre(21));
  EXPECT_THAT(restarts(joined(t, {0, 0, 1})), ElementsAre(22));
  EXPECT_THAT(restarts(joined(t, {0, 20})), IsEmpty());
  EXPECT_THAT(restarts(joined(t, {0, 19})), ElementsAre(21));
  EXPECT_THAT(restarts(joined(t, {0, 1, 2, 3, 4, 3})), IsEmpty());
  EXPECT_THAT(restarts(joined(t, {0, 1, 2, 3, 4, 5, 4})), ElementsAre(21));
  const double missing = std::nan("");
  EXPECT_THAT(restarts(joined(t, {missing, 0, missing, 1, 2, 3, 4, missing, 3})), IsEmpty());
  EXPECT_THAT(restarts(joined({missing}, joined(t, {0, missing, 1}))), ElementsAre(22));
  EXPECT_THAT(restarts({}), IsEmpty());
}

TEST(Rising, TwoRowsSuffice) {
  EXPECT_THAT(rising({0, 1})->kept, ElementsAre(0, 1));
  EXPECT_THAT(rising({5})->kept, ElementsAre(0));
  EXPECT_EQ(in_words(rising({1, 0}).error()), "the time runs backward from the first row to the last");
  EXPECT_EQ(in_words(rising({1, 1}).error()), "the time stands still: all its values are equal");
  EXPECT_EQ(in_words(rising({2, 2, 1}).error()), "the time runs backward from the first row to the last");
}

TEST(Rising, AsManyBackwardAsForwardStepsAreEndured) {
  EXPECT_THAT(rising({0, 2, 1})->kept, ElementsAre(0, 1));
  EXPECT_EQ(in_words(rising({0, 3, 2, 1}).error()), "the time runs backward in most rows");
  EXPECT_THAT(rising({0, 0, 0, 2, 1})->kept, ElementsAre(0, 3));
}

TEST(Rising, WhatIsLeftOutIsCountedFromItsFirstLine) {
  const auto kept = rising({0, 1, 1, 2, 1.5, 2, 3, 1, 4, 5});
  EXPECT_THAT(kept->kept, ElementsAre(0, 1, 3, 6, 8, 9));
  EXPECT_THAT(in_words(kept->notices),
              ElementsAre("2 rows with a repeated time left out, the first in line 13",
                          "2 rows with a backward time left out, the first in line 15"));
  EXPECT_THAT(in_words(rising({0, 1, 2})->notices), IsEmpty());
}

TEST(Rising, ARestartEndsIt) {
  const auto kept = rising(joined(counted_from(5, 21), {25, 5, 6, 7}));
  EXPECT_EQ(kept->kept.size(), 21u);
  EXPECT_THAT(in_words(kept->notices),
              ElementsAre("the time starts again in line 33: the 3 rows from there on are left out",
                          "1 row with a repeated time left out, the first in line 32"));
  const auto glitch = rising(joined(counted_from(5, 10), {5, 6, 15, 16}));
  EXPECT_EQ(glitch->kept.size(), 12u);
  EXPECT_THAT(in_words(glitch->notices),
              ElementsAre("2 rows with a backward time left out, the first in line 21"));
}

TEST(TimeColumn, IsTheNearestBeforeElseOfTheRunElseOfAll) {
  const auto table = [](const std::vector<std::pair<const char*, int>>& columns) {
    Table made;
    for (const auto& [quantity, run] : columns) made.columns.push_back({"c", quantity, "", run, {}});
    return made;
  };
  const auto two = table({{"time", 1}, {"position", 1}, {"time", 1}, {"position", 1}, {"position", 2}});
  EXPECT_EQ(time_column_of(two, 1), 0u);
  EXPECT_EQ(time_column_of(two, 3), 2u);
  EXPECT_EQ(time_column_of(two, 4), 0u);
  EXPECT_EQ(time_column_of(two, 0), 2u);
  EXPECT_EQ(time_column_of(two, 2), 0u);
  const auto behind = table({{"position", 2}, {"time", 1}, {"time", 2}});
  EXPECT_EQ(time_column_of(behind, 0), 2u);
  EXPECT_EQ(time_column_of(behind, 1), 2u);
  EXPECT_EQ(time_column_of(table({{"position", 1}, {"time", 1}}), 1), std::nullopt);
}

std::vector<double> times(int samples, double step) {
  std::vector<double> t;
  for (int i = 0; i < samples; ++i) t.push_back(i * step);
  return t;
}

/// Each time stamp off by up to `jitter`, evenly or normally spread.
std::vector<double> jittered(std::vector<double> t, double jitter, bool normal, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> bell(0, jitter);
  std::uniform_real_distribution<double> even(-jitter, jitter);
  for (double& at : t) at += normal ? bell(random) : even(random);
  return t;
}

TEST(Steps, RatesAreRoundWhereTheTimesAre) {
  for (const double rate : {100.0, 50.0, 30.0, 44100.0, 1e6, 0.1, 610.3515625, 12.5})
    EXPECT_EQ(describe_steps(times(3000, 1 / rate)).rate, rate) << rate;
  std::vector<double> summed{0};
  for (int i = 0; i < 3000; ++i) summed.push_back(summed.back() + 0.01);
  EXPECT_EQ(describe_steps(summed).rate, 100);
  EXPECT_LT(describe_steps(summed).jitter, 1e-9);
  EXPECT_EQ(describe_steps(times(3000, 0.01)).jitter, 0);
  // What is not round stays what it is.
  EXPECT_EQ(describe_steps(times(3000, 1 / 99.9876)).rate, 99.9876);
  EXPECT_EQ(describe_steps(times(3000, 0.03)).rate, 33.3333333333);
}

// A camera's times with three decimals: the usual step, 0.033 s, is no thirtieth.
TEST(Steps, ARateIsTheMeanOfTheSteps) {
  std::vector<double> t;
  for (int i = 0; i < 360; ++i) t.push_back(std::round(1000 * (0.2 + i / 30.0)) / 1000);
  EXPECT_NEAR(describe_steps(t).rate, 30, 1e-3);
}

TEST(Steps, JitterIsNoGap) {
  for (unsigned seed = 1; seed <= 20; ++seed)
    for (const bool normal : {false, true}) {
      const Steps steps = describe_steps(jittered(times(3000, 0.01), 0.002, normal, seed));
      EXPECT_TRUE(steps.gaps.empty()) << steps.gaps.size() << " gaps, seed " << seed << (normal ? " n" : "");
      EXPECT_GT(steps.jitter, 0.1);
    }
}

TEST(Steps, AMissingSampleIsAGapAlsoAmongJitter) {
  for (const double jitter : {0.0, 0.001}) {
    std::vector<double> t = times(3000, 0.01);
    for (const int lost : {2500, 1200, 600}) t.erase(t.begin() + lost);
    const auto gaps = describe_steps(jittered(t, jitter, false, 3)).gaps;
    ASSERT_EQ(gaps.size(), 3u) << jitter;
    EXPECT_NEAR(gaps[0].t, 5.99, 0.002);
    EXPECT_NEAR(gaps[0].length, 0.02, 0.003);
  }
}

TEST(Steps, AGapIsNoJitter) {
  std::vector<double> t = times(3000, 0.01);
  t.erase(t.begin() + 500, t.begin() + 800);
  const Steps steps = describe_steps(t);
  EXPECT_EQ(steps.gaps.size(), 1u);
  EXPECT_LT(steps.jitter, 1e-6);
}

TEST(Steps, OneLateSampleIsNoGap) {
  std::vector<double> t = times(100, 0.01);
  t[50] += 0.007;
  EXPECT_TRUE(describe_steps(t).gaps.empty());
  EXPECT_TRUE(describe_steps(std::vector<double>{1}).gaps.empty());
}

/// To the nearest multiple of `to`.
std::vector<double> rounded_to(std::vector<double> t, double to) {
  for (double& at : t) at = std::nearbyint(at / to) * to;
  return t;
}

// Tracker writes times with four digits: 9.967E0, 1.000E1, 1.003E1.
TEST(Steps, TimesOfSoManyDigitsAreMadeEven) {
  for (const double rate : {29.97, 30.0, 60.0})
    for (const double seconds : {25.0, 95.0}) {
      std::vector<double> t = times(static_cast<int>(seconds * rate), 1 / rate);
      for (double& each : t) {
        char text[32];
        std::snprintf(text, sizeof text, "%.3E", each);
        each = std::strtod(text, nullptr);
      }
      const Steps steps = describe_steps(t);
      ASSERT_TRUE(steps.clock) << rate << " " << seconds;
      EXPECT_NEAR(steps.clock->spacing * rate, 1, 1e-4);
      EXPECT_NEAR(steps.clock->rounding, 0.01, 1e-9);
      EXPECT_TRUE(steps.gaps.empty());
    }
}

TEST(Steps, RoundedTimesHaveNoGaps) {
  for (const double rate : {30.0, 48.0, 59.94, 60.0, 70.0, 83.0, 96.7, 100.0, 117.0, 190.0})
    for (const double part : {0.05, 0.2, 1 / 3.0, 0.5, 0.6, 0.8})
      for (const double start : {0.0, 0.3}) {
        std::vector<double> t = times(2000, 1 / rate);
        for (double& at : t) at += start / rate;
        const Steps steps = describe_steps(rounded_to(t, part / rate));
        EXPECT_TRUE(steps.gaps.empty()) << steps.gaps.size() << " gaps, " << rate << ' ' << part;
        EXPECT_NEAR(steps.rate, rate, 1e-3 * rate) << part;
      }
}

TEST(Steps, AGapAmongRoundedTimesIsOne) {
  for (const double to : {0.002, 0.005, 0.008, 0.01}) {
    std::vector<double> t = times(2000, 1 / 70.0);
    t.erase(t.begin() + 500, t.begin() + 505);
    const Steps steps = describe_steps(rounded_to(t, to));
    ASSERT_EQ(steps.gaps.size(), 1u) << to;
    EXPECT_NEAR(steps.gaps[0].t, 499 / 70.0, to);
    EXPECT_NEAR(steps.gaps[0].length, 6 / 70.0, to);
    // Its sides are times of the samples as they are taken.
    const std::vector<double>& taken = steps.clock ? steps.clock->t : rounded_to(t, to);
    EXPECT_EQ(steps.gaps[0].t, taken[499]) << to;
    EXPECT_EQ(steps.gaps[0].t + steps.gaps[0].length, taken[500]) << to;
  }
}

TEST(Steps, WhatWasEvenBeforeItWasRoundedIsMadeEven) {
  for (const double rate : {60.0, 70.0, 96.7})
    for (const double part : {0.13, 0.3, 0.51, 0.8}) {
      const std::vector<double> even = times(1500, 1 / rate);
      const auto clock = describe_steps(rounded_to(even, part / rate)).clock;
      ASSERT_TRUE(clock) << rate << ' ' << part;
      EXPECT_NEAR(clock->rounding, part / rate, 1e-4 * part / rate);
      for (const std::size_t i : {0u, 700u, 1499u}) EXPECT_NEAR(clock->t[i], even[i], 0.1 * part / rate);
    }
  // With samples missing.
  std::vector<double> t = times(1500, 1 / 70.0);
  t.erase(t.begin() + 400, t.begin() + 431);
  const auto clock = describe_steps(rounded_to(t, 0.005)).clock;
  ASSERT_TRUE(clock);
  for (std::size_t i = 0; i < t.size(); ++i) ASSERT_NEAR(clock->t[i], t[i], 5e-4) << i;
}

TEST(Steps, JitterIsNotMadeEven) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    EXPECT_FALSE(describe_steps(rounded_to(jittered(times(1500, 1 / 70.0), 0.002, true, seed), 0.005)).clock);
    EXPECT_FALSE(describe_steps(jittered(times(1500, 1 / 70.0), 0.001, false, seed)).clock);
  }
  EXPECT_FALSE(describe_steps(times(1500, 0.01)).clock);  // they are even
  EXPECT_FALSE(describe_steps(std::vector<double>{0, 1, 2.5}).clock);
}

// A round number near by is not the rate unless the times agree with it: 29.67 Hz for 29.674 Hz would be
// wrong by more than a fit's error.
TEST(Steps, OfAClockAreAsExactAsItsRoundedTimes) {
  struct Case {
    double step, rounding;
  };
  for (const auto& [step, rounding] : {Case{0.0234, 0.01},
                                       {0.0337, 0.01},
                                       {0.0417, 0.02},
                                       {0.0123, 0.005},
                                       {0.0167, 0.001},
                                       {0.02918, 0.01}})
    for (const std::size_t n : {60, 400, 3000})
      for (const double begin : {0.0, 0.0041, 0.0083}) {
        std::vector<double> t = times(static_cast<int>(n), step);
        for (double& each : t) each += begin;
        const auto clock = describe_steps(rounded_to(t, rounding)).clock;
        ASSERT_TRUE(clock) << step << ' ' << n;
        // Of the order of the rounding over the square of the number, not over the duration.
        const double most = 16 * rounding / (static_cast<double>(n) * static_cast<double>(n));
        EXPECT_NEAR(clock->spacing, step, most) << step << ' ' << n << ' ' << begin;
        EXPECT_LE(std::abs(clock->spacing - step), 3 * clock->error * step + 1e-12) << step << ' ' << n;
      }
  for (const double rate : {30.0, 60.0, 70.0, 29.97}) {
    const auto clock = describe_steps(rounded_to(times(3000, 1 / rate), 0.005)).clock;
    ASSERT_TRUE(clock) << rate;
    EXPECT_DOUBLE_EQ(clock->spacing, 1 / rate);
    EXPECT_EQ(clock->error, 0);
  }
  // 30 pictures a second, or 29.97? Two seconds do not tell.
  const auto video = describe_steps(rounded_to(times(60, 1001 / 30000.0), 0.01)).clock;
  ASSERT_TRUE(video);
  EXPECT_LT(std::abs(video->spacing * 30000 / 1001 - 1), 3 * video->error);
  EXPECT_GT(video->error, 1e-4);
}

TEST(Steps, OfAClockThatJittersAreAsExactAsLeastSquares) {
  int far = 0, clocks = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const std::vector<double> t = rounded_to(jittered(times(400, 0.0337), 5e-4, true, seed), 0.01);
    const auto clock = describe_steps(t).clock;
    if (!clock) continue;
    ++clocks;
    far += std::abs(clock->spacing / 0.0337 - 1) > 2 * clock->error;
  }
  EXPECT_GT(clocks, 20);
  EXPECT_LE(far, clocks / 8);
}

TEST(Steps, AShortLastOneIsNoRounding) {
  std::vector<double> t;
  for (int i = 0; i < 667; ++i) t.push_back(std::round(3000 * i) / 1e5);
  t.push_back(20);  // 0.02 s after 19.98 s
  EXPECT_FALSE(describe_steps(t).clock);
  EXPECT_NEAR(describe_steps(t).rate, 667 / 20.0, 1e-6);
}

TEST(Steps, OfFewTimes) {
  EXPECT_EQ(describe_steps(std::vector<double>{}).rate, 0);
  EXPECT_EQ(describe_steps(std::vector<double>{7}).rate, 0);
  const Steps two = describe_steps(std::vector<double>{7, 7.5});
  EXPECT_EQ(two.rate, 2);
  EXPECT_EQ(two.jitter, 0);
  EXPECT_TRUE(two.gaps.empty());
  EXPECT_EQ(describe_steps(std::vector<double>{0, 1, 2.5}).rate, 0.8);
}

/// A second apart; some are late.
std::vector<double> late(int samples, int from, int to, double by) {
  std::vector<double> t = times(samples, 1);
  for (int i = from; i < to; ++i) t[static_cast<std::size_t>(i)] += by;
  return t;
}

TEST(Steps, AGapIsHalfAStepAndLasts) {
  for (const int samples : {40, 63, 64, 100}) {
    EXPECT_EQ(describe_steps(late(samples, 20, samples, 0.51)).gaps.size(), 1u) << samples;
    EXPECT_EQ(describe_steps(late(samples, 20, samples, 0.49)).gaps.size(), 0u) << samples;
  }
  // Six of the ten times behind it, or all there are.
  EXPECT_EQ(describe_steps(late(40, 20, 25, 0.7)).gaps.size(), 0u);
  EXPECT_EQ(describe_steps(late(40, 20, 26, 0.7)).gaps.size(), 1u);
  EXPECT_EQ(describe_steps(late(40, 39, 40, 0.7)).gaps.size(), 1u);
  EXPECT_EQ(describe_steps(late(40, 37, 38, 0.7)).gaps.size(), 0u);
  EXPECT_EQ(describe_steps(late(40, 1, 40, 0.7)).gaps.size(), 1u);
  EXPECT_EQ(describe_steps(late(40, 0, 1, -0.7)).gaps.size(), 1u);
  EXPECT_EQ(describe_steps(late(40, 0, 5, -0.7)).gaps.size(), 1u);
  const auto gap = describe_steps(late(40, 20, 40, 0.7)).gaps.at(0);
  EXPECT_EQ(gap.t, 19);
  EXPECT_DOUBLE_EQ(gap.length, 1.7);
}

TEST(Steps, WhereHalfIsMissingTheMedianStepIsUsual) {
  for (const double step : {0.5, 1.0, 2.0}) {
    std::vector<double> t;
    for (int i = 0; i < 50; ++i) t.push_back(4 * i * step), t.push_back((4 * i + 1) * step);
    EXPECT_EQ(describe_steps(t).gaps.size(), 49u) << step;
  }
}

TEST(Steps, JitterIsTheirDeviationOverTheMedian) {
  // Steps of 1.5 and 0.5 beside eight of 1.
  EXPECT_DOUBLE_EQ(describe_steps(late(11, 5, 6, 0.5)).jitter, std::sqrt(0.05));
  EXPECT_EQ(describe_steps(late(40, 20, 40, 5)).jitter, 0);
  std::vector<double> slow = late(11, 5, 6, 0.5);
  for (double& t : slow) t *= 4;
  EXPECT_DOUBLE_EQ(describe_steps(slow).jitter, std::sqrt(0.05));
}

TEST(Steps, RatesHaveTwelveDigits) {
  EXPECT_EQ(describe_steps(times(100, 1 / 3.14159265358979)).rate, 3.14159265359);
  EXPECT_EQ(describe_steps(times(100, 1e-200)).rate, 1e200);
  EXPECT_EQ(describe_steps(times(100, 700)).rate, 0.00142857142857);
}

TEST(Steps, SixteenRoundedTimesShowAClock) {
  EXPECT_TRUE(describe_steps(rounded_to(times(16, 1 / 70.0), 0.005)).clock);
  EXPECT_FALSE(describe_steps(rounded_to(times(15, 1 / 70.0), 0.005)).clock);
}

TEST(Steps, ATwentiethOfAStepIsRounding) {
  EXPECT_TRUE(describe_steps(rounded_to(times(1500, 1), 0.0523)).clock);
  EXPECT_FALSE(describe_steps(rounded_to(times(1500, 1), 0.0477)).clock);
}

TEST(Steps, AClockMayBeginAnywhere) {
  for (const double begin : {0.0, -3.0, 1000.0}) {
    std::vector<double> t = times(600, 1 / 60.0);
    for (double& at : t) at += begin;
    const auto clock = describe_steps(rounded_to(t, 0.01)).clock;
    ASSERT_TRUE(clock) << begin;
    EXPECT_NEAR(clock->spacing, 1 / 60.0, 1e-9);
    EXPECT_NEAR(clock->rounding, 0.01, 1e-6);
    EXPECT_NEAR(clock->t.front(), begin, 1e-3);
    // A start at 0 is 0: it is a multiple of a millionth of a step.
    EXPECT_NEAR(std::remainder(clock->t.front() / clock->spacing * 1e6, 1.0), 0, 1e-4);
    EXPECT_NEAR(clock->t.back(), begin + 599 / 60.0, 1e-3);
  }
}

TEST(Steps, MissingSamplesAreNoRounding) {
  // Every tenth is missing: steps of one and two, but no clock between them.
  std::vector<double> t;
  for (int i = 0; i < 1000; ++i)
    if (i % 10 != 5) t.push_back(i);
  EXPECT_FALSE(describe_steps(t).clock);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::dialects
