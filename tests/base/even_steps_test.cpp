#include "cromer/base/even_steps.h"

#include <gtest/gtest.h>

#include <vector>

namespace cromer::core {
namespace CROMER_FILE {

TEST(EvenSteps, TellHowFarAStepIsFromTheirMean) {
  const EvenSteps two = even_steps(std::vector<double>{1, 3});
  EXPECT_EQ(two.mean, 2);
  EXPECT_EQ(two.farthest, 0);
  // Wherever the odd step stands, among few and among many.
  for (const std::size_t n : {3, 4, 5, 6, 7, 8, 9, 40, 41})
    for (std::size_t late = 1; late < n; ++late) {
      std::vector<double> t;
      for (std::size_t i = 0; i < n; ++i) t.push_back(static_cast<double>(i) + (i >= late ? 0.5 : 0));
      const double mean = 1 + 0.5 / static_cast<double>(n - 1);
      EXPECT_DOUBLE_EQ(even_steps(t).mean, mean);
      EXPECT_DOUBLE_EQ(even_steps(t).farthest, n == 2 ? 0 : 1.5 - mean) << n << ' ' << late;
    }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
