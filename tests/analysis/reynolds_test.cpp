#include "cromer/analysis/reynolds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cromer/analysis/air.h"

namespace cromer {
namespace {

TEST(Air, HasThePublishedValues) {
  // U.S. Standard Atmosphere 1976, sea level (288.15 K).
  EXPECT_NEAR(air_density(288.15), 1.2250, 0.0001);
  EXPECT_NEAR(air_dynamic_viscosity(288.15), 1.7894e-5, 0.0001e-5);
  EXPECT_NEAR(air_kinematic_viscosity(288.15), 1.4607e-5, 0.0001e-5);
  EXPECT_NEAR(air_kinematic_viscosity(293.15), 1.51e-5, 0.005e-5);
}

TEST(Reynolds, IsSpeedTimesDiameterOverViscosity) {
  EXPECT_DOUBLE_EQ(reynolds_number(-0.3, 0.12, 1.5e-5), 2400);
}

TEST(SpeedWindows, FindTheTopBetweenSamples) {
  // A decaying swing: each window holds the turning of the speed at its own height.
  const double w = 9, g = 0.02, h = 0.02;
  std::vector<double> t, v;
  for (int i = 0; i <= 500; ++i) {
    t.push_back(3 + h * i);
    v.push_back(-0.3 * std::exp(-g * h * i) * std::sin(w * h * i));
  }
  const auto windows = speed_windows(t, v, 0.5);
  ASSERT_EQ(windows.size(), 20u);
  for (const SpeedWindow& window : windows) {
    double top = 0;
    for (int i = 0; i < 5000; ++i) {
      const double s = window.t - 3 + 1e-4 * i;
      top = std::max(top, std::abs(0.3 * std::exp(-g * s) * std::sin(w * s)));
    }
    EXPECT_NEAR(window.speed, top, 2e-3 * top) << window.t;  // the samples alone may read 0.4 % low
    EXPECT_GE(window.at, window.t);
    EXPECT_LE(window.at, window.t + 0.5);
  }
}

TEST(SpeedWindows, OnlyWholeOnesCount) {
  const std::vector<double> t{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, v(7, 1.0);
  EXPECT_EQ(speed_windows(t, v, 0.5).size(), 1u);
  EXPECT_EQ(speed_windows(t, v, 1.0).size(), 0u);
  EXPECT_TRUE(speed_windows({}, {}, 0.5).empty());
}

}  // namespace
}  // namespace cromer
