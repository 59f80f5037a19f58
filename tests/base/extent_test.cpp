#include "cromer/base/extent.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cromer::core {
namespace CROMER_FILE {

TEST(Extent, IsTheLowestAndTheHighestWhereverTheyStand) {
  for (std::size_t n = 1; n <= 20; ++n)
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<double> values(n, 1.5);
      values[i] = -2;
      EXPECT_EQ(extent_of(values).low, -2) << i << " of " << n;
      EXPECT_EQ(extent_of(values).high, n == 1 ? -2 : 1.5) << i << " of " << n;
      values[i] = 7;
      EXPECT_EQ(extent_of(values).low, n == 1 ? 7 : 1.5) << i << " of " << n;
      EXPECT_EQ(extent_of(values).high, 7) << i << " of " << n;
      values[i] = NAN;
      EXPECT_EQ(extent_of(values).low, n == 1 ? INFINITY : 1.5) << i << " of " << n;
    }
  EXPECT_GT(extent_of({}).low, extent_of({}).high);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
