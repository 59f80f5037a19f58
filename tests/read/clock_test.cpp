// The even clock behind rounded times, against what the times alone allow.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cromer/read/time.h"

namespace cromer::core::dialects {
namespace CROMER_FILE {

struct Logged {
  double step, rounding, begin;
  int samples;
  std::vector<int> lost{};  ///< numbers of samples that are missing
};

/// The numbers of the samples that are there.
std::vector<double> numbers(const Logged& logged) {
  std::vector<double> all;
  for (int k = 0; k < logged.samples; ++k)
    if (std::find(logged.lost.begin(), logged.lost.end(), k) == logged.lost.end()) all.push_back(k);
  return all;
}

std::vector<double> rounded_times(const Logged& logged) {
  std::vector<double> t = numbers(logged);
  for (double& each : t)
    each = std::nearbyint((logged.begin + each * logged.step) / logged.rounding) * logged.rounding;
  return t;
}

struct Slopes {
  double low = -HUGE_VAL, high = HUGE_VAL;
};

/// All steps with which times may be off by half a rounding each: by pairs, each of which bounds it.
Slopes allowed(const std::vector<double>& t, const std::vector<double>& number, double rounding) {
  Slopes found;
  for (std::size_t j = 0; j < t.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      found.low = std::max(found.low, (t[j] - t[i] - rounding) / (number[j] - number[i]));
      found.high = std::min(found.high, (t[j] - t[i] + rounding) / (number[j] - number[i]));
    }
  return found;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double slope_of_least_squares(const std::vector<double>& t, const std::vector<double>& number) {
  double products = 0, squares = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    products += (t[i] - mean(t)) * (number[i] - mean(number));
    squares += std::pow(number[i] - mean(number), 2);
  }
  return products / squares;
}

TEST(Clock, ItsStepIsTheMiddleOfThoseThatTheTimesAllow) {
  for (const Logged& each : {Logged{0.0123715926, 0.005, 0, 200},
                             {0.0141421356, 0.01, 3.3, 80},
                             {0.0141421356, 0.0011, -2, 300},
                             {1.6180339887, 0.25, 0.1, 40},
                             {1.6180339887, 1, 1000, 120},
                             {27.182818284, 5, 0, 17},
                             {0.0334729843, 0.01, 0.004, 90, {3, 40, 41, 42, 77}},
                             {0.0334729843, 0.002, 0.004, 60, {1, 2, 3, 58}}}) {
    const std::vector<double> t = rounded_times(each), number = numbers(each);
    const auto clock = describe_steps(t).clock;
    ASSERT_TRUE(clock) << each.step << ' ' << each.rounding;
    const auto [low, high] = allowed(t, number, each.rounding);
    const double width = high - low;
    ASSERT_GT(width, 0);
    EXPECT_NEAR(clock->spacing, 0.5 * (low + high), 1e-4 * width) << each.step << ' ' << each.rounding;
    EXPECT_NEAR(clock->error * clock->spacing, width / std::sqrt(12), 1e-4 * width) << each.step;
    EXPECT_DOUBLE_EQ(clock->rounding, each.rounding);
    ASSERT_EQ(clock->t.size(), t.size());
    for (std::size_t i = 1; i < t.size(); ++i)
      EXPECT_NEAR((clock->t[i] - clock->t[0]) / clock->spacing, number[i] - number[0], 1e-6) << i;
    // With the times it agrees best in the middle.
    const double middle = 0.5 * (number.front() + number.back());
    const double at_middle = mean(t) + slope_of_least_squares(t, number) * (middle - mean(number));
    EXPECT_NEAR(clock->t[0] + clock->spacing * (middle - number[0]), at_middle, 0.51e-6 * clock->spacing);
    EXPECT_NEAR(std::remainder(clock->t[0] / clock->spacing * 1e6, 1), 0, 1e-3);
  }
}

// Where no clock explains all times: one of them is a rounding late, but hardly farther off than the others.
TEST(Clock, OfTimesThatJitterIsTheLineOfLeastSquares) {
  for (const Logged& each : {Logged{0.0141421356, 0.005, 0, 300}, {1.6180339887, 0.5, 7, 150}}) {
    std::vector<double> t = rounded_times(each);
    const std::vector<double> number = numbers(each);
    const auto off = [&](std::size_t k) {
      return (t[k] - each.begin - number[k] * each.step) / each.rounding;
    };
    std::size_t k = 20;
    while (!(off(k) > -0.36 && off(k) < -0.32)) ASSERT_LT(++k, t.size());
    t[k] += each.rounding;
    const auto clock = describe_steps(t).clock;
    ASSERT_TRUE(clock) << each.step;
    const auto [low, high] = allowed(t, number, each.rounding);
    ASSERT_GT(low, high);
    EXPECT_NEAR(clock->spacing, slope_of_least_squares(t, number), 1e-10 * each.step);
    // A step's standard error, times off evenly by half a rounding: that of a slope.
    const double error = each.rounding / std::pow(each.samples, 1.5);
    EXPECT_NEAR(clock->error * clock->spacing, error, 1e-6 * error);
  }
}

TEST(Clock, StepsOfOneAndTwoRoundingsAreOneIfATenthIsOfTwo) {
  for (const double rounding : {0.01, 1.0, 100.0}) {
    const auto is_one = [&](int samples, double step) {
      const Logged logged{step * rounding, rounding, 0.73 * rounding, samples};
      return describe_steps(rounded_times(logged)).clock.has_value();
    };
    // From 1 to 110, in 99 steps, 100 and from 0 to 109.
    EXPECT_TRUE(is_one(100, 1.1)) << rounding;
    EXPECT_FALSE(is_one(101, 1.1)) << rounding;
    EXPECT_FALSE(is_one(100, 1.09)) << rounding;
  }
}

TEST(Clock, TimesMayBeOffByAMillionthOfAStep) {
  std::vector<double> t = rounded_times({1 / 70.0, 0.005, 0, 200});
  for (std::size_t i = 0; i < t.size(); ++i) t[i] += i % 2 == 0 ? 2e-9 : -2e-9;
  const auto clock = describe_steps(t).clock;
  ASSERT_TRUE(clock);
  EXPECT_EQ(clock->rounding, 0.005);
  for (std::size_t i = 0; i < t.size(); ++i) t[i] += i % 2 == 0 ? 2e-7 : -2e-7;
  EXPECT_FALSE(describe_steps(t).clock);
}

TEST(Clock, TwelveLengthsOfStepsAreRounding) {
  for (const int gaps : {10, 11}) {
    Logged logged{1.1, 0.25, 0, 0};
    for (int gap = 1; gap <= gaps; ++gap) {
      logged.samples += 60;
      for (int k = 0; k < gap; ++k) logged.lost.push_back(logged.samples++);
    }
    logged.samples += 60;
    EXPECT_EQ(describe_steps(rounded_times(logged)).clock.has_value(), gaps == 10) << gaps;
  }
}

TEST(Pace, IsThatOfSixteenStepsWhereThereAreSixtyFourTimes) {
  const auto gaps = [](int samples) {
    std::vector<double> t{0};
    for (int i = 1; i < samples; ++i) t.push_back(t.back() + (i % 3 == 2 ? 1 : 0.6));
    return describe_steps(t).gaps.size();
  };
  // A second is 1.67 of the usual steps, and 1.36 of their mean.
  EXPECT_GT(gaps(63), 15u);
  EXPECT_EQ(gaps(64), 0u);
  EXPECT_EQ(gaps(65), 0u);
}

/// 0, 1, ..., 39, but that five from `from` on are off, and one beside them.
std::size_t gaps_where_five(std::size_t from, double off, std::size_t beside = 0, double by = 0) {
  std::vector<double> t(40);
  std::iota(t.begin(), t.end(), 0);
  for (std::size_t i = from; i < from + 5; ++i) t[i] += off;
  t[beside] += by;
  return describe_steps(t).gaps.size();
}

// The medians of ten on either side of it are half a step apart: here 0.45, and 0.75.
TEST(Pace, AGapIsSeenOfTenTimesOnEitherSide) {
  EXPECT_EQ(gaps_where_five(20, 0.9), 0u);
  EXPECT_EQ(gaps_where_five(20, 1.2, 25, 0.3), 1u);
  EXPECT_EQ(gaps_where_five(15, -0.9), 0u);
  EXPECT_EQ(gaps_where_five(15, -1.2, 14, -0.3), 1u);
}

TEST(Pace, OfTimesFarFromZeroIsTheirMean) {
  std::vector<double> t;
  for (int i = 0; i < 3000; ++i) t.push_back(1e9 + 0.0012345678 * i);
  EXPECT_NEAR(describe_steps(t).rate * 0.0012345678, 1, 1e-7);
}

TEST(Clock, ARoundStepOrRateIsItsOwnWhereItIsNotThereByChance) {
  const auto of = [](double step, double rounding, int samples) {
    return *describe_steps(rounded_times({step, rounding, 0, samples})).clock;
  };
  EXPECT_EQ(of(0.025, 0.01, 100).spacing, 0.025);
  EXPECT_EQ(of(0.025, 0.01, 100).error, 0);
  EXPECT_EQ(of(0.0123, 0.005, 1000).spacing, 0.0123);
  EXPECT_EQ(of(1 / 43.0, 0.01, 400).spacing, 1 / 43.0);
  EXPECT_EQ(of(1 / 43.2, 0.01, 4000).spacing, 1 / 43.2);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::dialects
