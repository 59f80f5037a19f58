#include "apps/web/core/powers_of_five.h"

#include <fast_float/fast_float.h>
#include <gtest/gtest.h>

namespace cromer::core::page {
namespace CROMER_FILE {

TEST(PowersOfFive, AreThoseOfFastFloat) {
  using fast_float::powers;
  const auto computed = powers_of_five<powers::smallest_power_of_five, powers::largest_power_of_five>();
  ASSERT_EQ(computed.size(), static_cast<std::size_t>(powers::number_of_entries));
  for (std::size_t i = 0; i < computed.size(); ++i) EXPECT_EQ(computed[i], powers::power_of_five_128[i]) << i;
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::page
