#include "cromer/base/coarse_power.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cromer::core {
namespace {

TEST(CoarsePower, LogarithmIsAsGoodAsItSays) {
  double worst = 0;
  for (double x = 1e-300; x < 1e300; x *= 1.0371)
    worst = std::fmax(worst, std::abs(coarse_log2(x) - std::log2(x)));
  EXPECT_LT(worst, 9e-4);
  EXPECT_GT(worst, 8e-4);  // or the contract should say less
  for (const double power : {-40.0, -1.0, 0.0, 1.0, 7.0}) EXPECT_EQ(coarse_log2(std::exp2(power)), power);
}

TEST(CoarsePower, PowerIsAsGoodAsItSays) {
  double worst = 0;
  for (double y = -999; y < 999; y += 0.0371)
    worst = std::fmax(worst, std::abs(coarse_exp2(y) / std::exp2(y) - 1));
  EXPECT_LT(worst, 5e-6);
  EXPECT_GT(worst, 3e-6);
  for (const double whole : {-40.0, -1.0, 0.0, 1.0, 7.0}) EXPECT_EQ(coarse_exp2(whole), std::exp2(whole));
}

TEST(CoarsePower, FarPowersEndAtTheLimits) {
  EXPECT_EQ(coarse_exp2(1e9), std::exp2(1000));
  EXPECT_EQ(coarse_exp2(-1e9), std::exp2(-1000));
  EXPECT_EQ(coarse_exp2(1000.5), std::exp2(1000));
  EXPECT_EQ(coarse_exp2(-1000.5), std::exp2(-1000));
}

}  // namespace
}  // namespace cromer::core
