// What axes show: the data, room about them, and ends at ticks, at and beyond each limit.
#include "cromer/report/axis_range.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cromer {
namespace {

using ::testing::ElementsAre;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Panel panel_of(std::vector<double> x, std::vector<double> y) {
  Panel panel;
  Curve curve;
  curve.x = std::move(x);
  curve.y = std::move(y);
  panel.curves.push_back(std::move(curve));
  return panel;
}

/// Low, high and step of the y axis over these values.
std::vector<double> y_axis(std::vector<double> y) {
  std::vector<double> x(y.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(i);
  const Panel panel = panel_of(std::move(x), std::move(y));
  const AxisRange range = y_range(panel, x_range(panel));
  return {range.low, range.high, range.step};
}

std::vector<double> x_axis(const Panel& panel) {
  const AxisRange range = x_range(panel);
  return {range.low, range.high};
}

TEST(YRange, EndsAtTicksWhereThatTakesLittleRoom) {
  EXPECT_THAT(y_axis({-0.9, 0.9}), ElementsAre(-1, 1, 1));
  EXPECT_THAT(y_axis({-3.3, 3.3}), ElementsAre(-4, 4, 2));
  // 0 to 1.05 would be rounded to 1.5 or 1.2: a quarter of the span at most is given away.
  EXPECT_THAT(y_axis({0, 1.05}), ElementsAre(0, 1.25, 0.25));
}

TEST(YRange, LeavesAHundredthBetweenTheCurveAndTheFrame) {
  EXPECT_THAT(y_axis({-0.97, 0.97}), ElementsAre(-1, 1, 1));  // 0.015 of the span
  const std::vector<double> near = y_axis({-0.985, 0.985});   // 0.0076: a twentieth of room then
  EXPECT_DOUBLE_EQ(near[0], -1.0835);
  EXPECT_DOUBLE_EQ(near[1], 1.0835);
  EXPECT_EQ(near[2], 0);
}

TEST(YRange, BeginsAtZeroWhereTheDataComeNearIt) {
  EXPECT_EQ(y_axis({5.9, 16})[0], 0);  // 5.9 is 0.58 of the span
  EXPECT_GT(y_axis({6.1, 16})[0], 0);  // 0.62
  EXPECT_EQ(y_axis({-16, -5.9})[1], 0);
  EXPECT_LT(y_axis({-16, -6.1})[1], 0);
}

TEST(YRange, OfOneValueIsATenthToEachSide) {
  const std::vector<double> five = y_axis({5, 5});
  EXPECT_LE(five[0], 4.5);
  EXPECT_GE(five[1], 5.5);
  EXPECT_GT(five[0], 0);
  EXPECT_LE(y_axis({0, 0})[0], -1);
  EXPECT_GE(y_axis({0, 0})[1], 1);
  const std::vector<double> nothing = y_axis({none, none});
  EXPECT_LE(nothing[0], 0);
  EXPECT_GE(nothing[1], 1);
}

TEST(YRange, IsThatOfTheCurvesThatSetIt) {
  Panel panel = panel_of({0, 1, 2}, {0, 1, 100});
  panel.x.high = 1;  // the last value is not in sight
  Curve other;
  other.x = {0, 1};
  other.y = {-50, 50};
  other.sets_axes = false;
  panel.curves.push_back(other);
  const AxisRange range = y_range(panel, x_range(panel));
  EXPECT_EQ(range.low, 0);
  EXPECT_LT(range.high, 1.3);
  panel.y.low = -2;
  panel.y.high = 7;
  EXPECT_EQ(y_range(panel, x_range(panel)).low, -2);
  EXPECT_EQ(y_range(panel, x_range(panel)).high, 7);
}

TEST(XRange, EndsWithTheDataOrAtATickCloseBy) {
  EXPECT_THAT(x_axis(panel_of({0, 7.31}, {0, 1})), ElementsAre(0, 7.31));
  EXPECT_THAT(x_axis(panel_of({0.05, 9.95}, {0, 1})), ElementsAre(0, 10));  // 0.05 of 9.9
  EXPECT_THAT(x_axis(panel_of({0.11, 9.89}, {0, 1})), ElementsAre(0.11, 9.89));
}

TEST(XRange, OfALogarithmicAxisLeavesOutWhatIsNotPositive) {
  Panel panel = panel_of({-1, 0, 0.2, 30}, {1, 1, 1, 1});
  panel.x.logarithmic = true;
  EXPECT_THAT(x_axis(panel), ElementsAre(0.2, 30));
  panel.x.low = -1;  // which it cannot begin at
  EXPECT_THAT(x_axis(panel), ElementsAre(0.2, 30));
  panel.x.low = 0.1;
  EXPECT_THAT(x_axis(panel), ElementsAre(0.1, 30));
  AxisRange range = x_range(panel);
  range.from = 100;
  range.to = 400;
  EXPECT_DOUBLE_EQ(range.px(0.1), 100);
  EXPECT_DOUBLE_EQ(range.px(std::sqrt(3.0)), 250);
  EXPECT_TRUE(std::isnan(range.px(0)));
}

TEST(PhasePortrait, IsCentredWhereTheDataLieOnBothSidesOfZero) {
  Panel panel = panel_of({-1, 3}, {2, 4});
  panel.phase_portrait = true;
  const AxisRange x = x_range(panel);
  EXPECT_DOUBLE_EQ(x.low, -3.3);  // a tenth of the span of 6 is room
  EXPECT_DOUBLE_EQ(x.high, 3.3);
  const AxisRange y = y_range(panel, x);
  EXPECT_DOUBLE_EQ(y.low, 1.9);
  EXPECT_DOUBLE_EQ(y.high, 4.1);
}

}  // namespace
}  // namespace cromer
