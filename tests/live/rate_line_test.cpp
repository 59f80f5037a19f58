#include "cromer/live/rate_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "arrivals.h"

namespace cromer::core::test {
namespace CROMER_FILE {

double sum_of_delays(const std::vector<double>& arrivals, const RateLine& line) {
  double sum = 0;
  for (std::size_t i = 0; i < arrivals.size(); ++i) {
    const double delay = arrivals[i] - line.at(static_cast<double>(i));
    if (delay < -1e-12) return std::numeric_limits<double>::infinity();
    sum += delay;
  }
  return sum;
}

// Against every line through two of the points: the best line touches two.
TEST(RateLine, IsTheLineBelowAllWithTheLeastSumOfDelays) {
  std::mt19937_64 engine(3);
  std::exponential_distribution<double> delay(2);
  for (const int count : {2, 3, 4, 5, 10, 40}) {
    for (int repeat = 0; repeat < 50; ++repeat) {
      std::vector<double> arrivals;
      for (int i = 0; i < count; ++i) arrivals.push_back(5 + 0.1 * i + delay(engine));
      double best = std::numeric_limits<double>::infinity();
      for (std::size_t a = 0; a < arrivals.size(); ++a)
        for (std::size_t b = a + 1; b < arrivals.size(); ++b) {
          const double period = (arrivals[b] - arrivals[a]) / static_cast<double>(b - a);
          best = std::min(best,
                          sum_of_delays(arrivals, {arrivals[a] - static_cast<double>(a) * period, period}));
        }
      EXPECT_NEAR(sum_of_delays(arrivals, line_below(arrivals)), best, 1e-9) << count;
    }
  }
}

TEST(RateLine, RoughnessIsOfDelaysAlone) {
  std::vector<double> smooth, rough;
  for (int i = 0; i < 1000; ++i) {
    const double t = 0.01 * i + 0.005 * std::sin(0.06 * i);
    smooth.push_back(t);
    rough.push_back(t + 0.001 * (i % 2));
  }
  EXPECT_LT(roughness(smooth), 2e-5);
  EXPECT_NEAR(roughness(rough), 2e-3, 2e-5);
  EXPECT_EQ(roughness(std::span<const double>(smooth).first(2)), 0);
}

TEST(RateLine, SteadyRateNeedsEnough) {
  std::vector<double> arrivals;
  for (int i = 0; i < 200; ++i) arrivals.push_back(3 + i / 100.0);
  const std::span<const double> all(arrivals);
  EXPECT_FALSE(steady_rate({}, 0.3));
  EXPECT_FALSE(steady_rate(all.first(47), 0.1));
  EXPECT_FALSE(steady_rate(all.first(50), 0.5));
  const auto line = steady_rate(all.first(50), 0.3);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->period, 0.01, 1e-12);
  EXPECT_NEAR(line->at(17), arrivals[17], 1e-9);
}

// The last part that is steady, counted from the first arrival all the same.
TEST(RateLine, SteadyRateLeavesOutWhatWasBefore) {
  std::vector<double> arrivals;
  for (int i = 0; i < 500; ++i) arrivals.push_back(i / 50.0);
  for (int i = 0; i < 500; ++i) arrivals.push_back(10 + i / 100.0);
  const auto line = steady_rate(arrivals, 0.3);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->period, 0.01, 1e-12);
  EXPECT_NEAR(line->at(999), arrivals[999], 1e-9);
}

TEST(RateLine, IsTouchedByArrivalsUpToAThirdOfAMillisecondLate) {
  // On time at both ends, all others late by the same.
  const auto touched = [](double late) {
    std::vector<double> arrivals;
    for (int i = 0; i < 400; ++i) arrivals.push_back(i / 100.0 + (i > 0 && i < 399 ? late : 0));
    return is_touched(arrivals, {0, 0.01});
  };
  EXPECT_TRUE(touched(2.9e-4));
  EXPECT_FALSE(touched(3.1e-4));
}

TEST(RateLine, IsTouchedAllInAllAndLately) {
  const auto touched = [](int from, int to, double late = 0.002) {
    std::vector<double> arrivals;
    for (int i = 0; i < 400; ++i) arrivals.push_back(i / 100.0 + (i >= from && i < to ? late : 0));
    return is_touched(arrivals, {0, 0.01});
  };
  EXPECT_TRUE(touched(0, 100));
  EXPECT_FALSE(touched(0, 250));
  EXPECT_TRUE(touched(100, 300));
  EXPECT_FALSE(touched(335, 400));
  EXPECT_TRUE(touched(350, 400));
}

TEST(RateLine, LatenessIsWhatNineOfTenPiecesHave) {
  std::vector<double> arrivals;
  for (int i = 0; i < 400; ++i) arrivals.push_back(i / 100.0 + (i >= 360 ? 0.5 : i >= 300 ? 0.25 : 0.125));
  EXPECT_NEAR(lateness(arrivals, {0, arrivals.back() / 399}), 0.25, 0.2);
  EXPECT_DOUBLE_EQ(lateness(std::vector<double>{0, 1, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5}, {0, 1}), 0.5);
}

TEST(RateLine, SteadyRateHasLimits) {
  const auto found = [](int count, double period, double least) {
    std::vector<double> arrivals;
    for (int i = 0; i < count; ++i) arrivals.push_back(100 + i * period);
    return steady_rate(arrivals, least).has_value();
  };
  EXPECT_TRUE(found(48, 0.01, 0.46));
  EXPECT_FALSE(found(47, 0.01, 0.3));
  EXPECT_FALSE(found(48, 0.01, 0.48));
  EXPECT_TRUE(found(10000, 5.1e-5, 0.3));
  EXPECT_FALSE(found(10000, 4.9e-5, 0.3));
  EXPECT_TRUE(found(48, 1, 0.3));
}

TEST(RateLine, RoughnessOfThreeIsTheirBend) {
  EXPECT_DOUBLE_EQ(roughness(std::vector<double>{0, 1, 2.0625}), 0.0625);
  EXPECT_DOUBLE_EQ(roughness(std::vector<double>{0, 1, 3}), 0.1);
  EXPECT_DOUBLE_EQ(roughness(std::vector<double>{0, 1, 2.0625, 3.125}), 0.03125);
  EXPECT_EQ(roughness(std::vector<double>{}), 0);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
