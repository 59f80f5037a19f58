#include "cromer/base/median.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace cromer::core
