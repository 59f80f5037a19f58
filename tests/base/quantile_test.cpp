#include "cromer/base/quantile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cromer::core {
namespace {

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

}  // namespace
}  // namespace cromer::core
