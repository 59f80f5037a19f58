#include "cromer/base/quantile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace cromer::core {
namespace CROMER_FILE {

TEST(UpperMedian, IsTheMiddleOrTheUpperOfTwo) {
  const auto median = [](std::vector<double> values) { return upper_median(values); };
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({7, 3}), 7);
  EXPECT_EQ(median({9, 1, 5}), 5);
  EXPECT_EQ(median({4, 1, 3, 2}), 3);
  EXPECT_EQ(median({5, 1, 4, 2, 3}), 3);
}

TEST(Median, IsTheMiddleOrTheMeanOfTwo) {
  EXPECT_TRUE(std::isnan(median({})));
  EXPECT_EQ(median({3}), 3);
  EXPECT_EQ(median({4, 1}), 2.5);
  EXPECT_EQ(median({9, 1, 5}), 5);
  EXPECT_EQ(median({9, 1, 5, 2}), 3.5);
}

TEST(Quantile, HasThatShareOfTheValuesBelowIt) {
  std::vector<double> values{7, 3, 9, 0, 5, 1, 8, 2, 6, 4};
  for (int tenths = 0; tenths < 10; ++tenths) EXPECT_EQ(quantile(values, 0.1 * tenths + 0.05), tenths);
  EXPECT_EQ(quantile(values, 0), 0);
  EXPECT_EQ(quantile(values, 0.99), 9);
}

// What many values have: spread out, all alike, nearly alike, one far away, a gap in the middle, no width.
std::vector<std::vector<double>> many_values() {
  std::mt19937_64 chance(3);
  std::normal_distribution<double> normal;
  std::vector<std::vector<double>> sets;
  for (const std::size_t n : {511, 512, 513, 1000, 4097}) {
    std::vector<double> spread(n), alike(n, 0.25), nearly(n), far(n), parted(n), whole(n), endless(n),
        tiny(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double x = normal(chance);
      spread[i] = x;
      nearly[i] = 1 + 1e-16 * std::floor(3 * x);
      far[i] = i == n / 3 ? 1e300 : x;
      parted[i] = i % 2 == 0 ? -1e6 + x : 1e6 + x;
      whole[i] = std::floor(2 * x);
      endless[i] = i == n / 3 ? std::numeric_limits<double>::infinity() : x;
      tiny[i] = std::floor(10 * x) * std::numeric_limits<double>::denorm_min();
    }
    for (auto* each : {&spread, &alike, &nearly, &far, &parted, &whole, &endless, &tiny})
      sets.push_back(*each);
  }
  return sets;
}

TEST(Quantile, OfManyValuesIsWhatSortingGives) {
  for (const std::vector<double>& values : many_values()) {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t n = values.size();
    for (const double share : {0.0, 0.01, 0.25, 0.5, 0.75, 0.999}) {
      std::vector<double> some = values;
      EXPECT_EQ(quantile(some, share), sorted[static_cast<std::size_t>(share * static_cast<double>(n))])
          << share << " of " << n;
    }
    EXPECT_EQ(median(values), n % 2 == 1 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2) << n;
  }
}

TEST(Quantile, ANaNDoesNoHarm) {
  std::vector<double> values(1000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
  values[500] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NEAR(quantile(values, 0.25), 250, 1);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
