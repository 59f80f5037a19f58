#include "cromer/analysis/air.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace cromer::core {
namespace CROMER_FILE {

TEST(Air, HasThePublishedValues) {
  // U.S. Standard Atmosphere 1976, sea level (288.15 K).
  EXPECT_NEAR(air_density(288.15), 1.2250, 0.0001);
  EXPECT_NEAR(air_dynamic_viscosity(288.15), 1.7894e-5, 0.0001e-5);
  EXPECT_NEAR(air_kinematic_viscosity(288.15), 1.4607e-5, 0.0001e-5);
  EXPECT_NEAR(air_kinematic_viscosity(293.15), 1.51e-5, 0.005e-5);
  // 216.65 K, and CODATA's molar volume of an ideal gas at 273.15 K and 101325 Pa.
  EXPECT_NEAR(air_dynamic_viscosity(216.65), 1.4216e-5, 0.0001e-5);
  EXPECT_NEAR(air_density(273.15) * 22.41396954e-3 / 28.9647e-3, 1, 1e-9);
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

/// Samples 1 s apart from `from` on, and after them what must not be read.
std::vector<SpeedWindow> windows_of(double from, std::vector<double> v, double length) {
  const std::size_t n = v.size();
  std::vector<double> t;
  for (std::size_t i = 0; i < n + 2; ++i) t.push_back(from + static_cast<double>(i));
  v.insert(v.end(), {-100, -100});
  return speed_windows(std::span(t).first(n), std::span(v).first(n), length);
}

void expect_window(const SpeedWindow& found, double t, double speed, double at) {
  EXPECT_NEAR(found.t, t, 1e-14);
  EXPECT_NEAR(found.speed, speed, 1e-14);
  EXPECT_NEAR(found.at, at, 1e-14);
}

TEST(SpeedWindows, TheTopIsThatOfTheParabolaUpToTheLastSampleButOne) {
  // Through (-1, 1), (0, 3), (1, 2): 3 + u/2 - 3 u^2/2.
  const auto first = windows_of(10, {1, 3, 2, 0, 0, 0}, 5.5), last = windows_of(10, {0, 0, 0, 1, 3, 2}, 5.5),
             falling = windows_of(10, {0, 0, 0, -1, -3, -2}, 5.5);
  ASSERT_EQ(first.size(), 1u);
  expect_window(first[0], 10, 3 + 1.0 / 24, 11 + 1.0 / 6);
  ASSERT_EQ(last.size(), 1u);
  expect_window(last[0], 10, 3 + 1.0 / 24, 14 + 1.0 / 6);
  ASSERT_EQ(falling.size(), 1u);
  expect_window(falling[0], 10, 3 + 1.0 / 24, 14 + 1.0 / 6);
}

TEST(SpeedWindows, AtTheEndsTheSampleItselfCounts) {
  expect_window(windows_of(10, {-5, 3, 2, 2.5}, 3.5).at(0), 10, 5, 10);
  expect_window(windows_of(10, {2, 3, 2, 5}, 3.5).at(0), 10, 5, 13);
}

TEST(SpeedWindows, TwoEqualNeighboursHaveTheirTopBetweenThem) {
  expect_window(windows_of(0, {1, 2, 2, 1, 0, 0}, 5.5).at(0), 0, 2.125, 1.5);
  expect_window(windows_of(0, {0, 0, -1, -2, -2, -1}, 5.5).at(0), 0, 2.125, 3.5);
}

TEST(SpeedWindows, OfEqualSpeedsTheFirstCounts) {
  for (const double v : {0.0, 4.0, -4.0})
    expect_window(windows_of(3, std::vector(6, v), 5.5).at(0), 3, std::abs(v), 3);
}

TEST(SpeedWindows, ASampleOnTheBoundaryBelongsToTheLaterWindow) {
  const auto found = windows_of(10, {1, 1, 1, 7, 1, 1, 1}, 3);
  ASSERT_EQ(found.size(), 2u);
  expect_window(found[0], 10, 1, 10);
  expect_window(found[1], 13, 7, 13);
}

TEST(SpeedWindows, ATopThatLiesInTheNextWindowIsReadAtTheEnd) {
  // The parabola through 0, 3, 2.9 turns after the sample at 12, but before 12.5.
  const auto found = windows_of(10, {0, 0, 3, 2.9, 0, 0, 0}, 2.25);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].at, 12.25);
  EXPECT_GT(found[0].speed, 3.3);
}

TEST(SpeedWindows, TheLastSampleStandsForHalfAStepAfterIt) {
  EXPECT_EQ(windows_of(10, {1, 1, 1, 1}, 1.75).size(), 2u);
  EXPECT_EQ(windows_of(10, {1, 1, 1, 1}, 1.7500001).size(), 1u);
  EXPECT_EQ(windows_of(10, {1, 1, 1, 1}, 3.5).size(), 1u);
  EXPECT_EQ(windows_of(10, {1, 1, 1, 1}, 3.5000001).size(), 0u);
  EXPECT_EQ(windows_of(10, {1, 1}, 1.5).size(), 1u);
  EXPECT_TRUE(windows_of(10, {1}, 0.5).empty()) << "of one sample no step is known";
}

TEST(SpeedWindows, OneWithoutASampleIsLeftOut) {
  const std::vector<double> t{10, 11, 12, 20, 21, 22}, v(6, 2.0);
  const auto found = speed_windows(t, v, 3);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].t, 10);
  EXPECT_EQ(found[1].t, 19);
  EXPECT_EQ(found[1].speed, 2);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
