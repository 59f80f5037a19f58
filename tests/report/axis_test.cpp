// What axes show: the data, room about them, and ends at ticks, at and beyond each limit.
#include "cromer/report/axis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
  std::vector<std::string> texts;
  for (const Tick& tick : ticks) texts.push_back(tick.label);
  return texts;
}

TEST(Ticks, StepsAreOneTwoTwoAndAHalfFive) {
  EXPECT_DOUBLE_EQ(tick_step(0, 8, 9), 1);
  EXPECT_DOUBLE_EQ(tick_step(0, 8, 6), 2);
  EXPECT_DOUBLE_EQ(tick_step(0, 120, 7), 20);
  EXPECT_DOUBLE_EQ(tick_step(-5.2, 5.2, 5), 2);
  EXPECT_DOUBLE_EQ(tick_step(-5.2, 5.2, 4), 5);
  EXPECT_DOUBLE_EQ(tick_step(0, 10, 5), 2.5);
  EXPECT_DOUBLE_EQ(tick_step(0, 0.003, 6), 0.001);
}

TEST(Ticks, NeverMoreThanAsked) {
  for (double low : {-7.3, 0.0, 0.013, 1e6}) {
    for (double span = 1e-6; span < 1e7; span *= 1.37) {
      for (int most : {3, 6, 7}) {
        const auto ticks = linear_ticks(low, low + span, tick_step(low, low + span, most));
        ASSERT_LE(static_cast<int>(ticks.size()), most) << low << " " << span;
        ASSERT_GE(ticks.size(), 1u) << low << " " << span;
      }
    }
  }
}

TEST(Ticks, BothEndsBelongInSpiteOfRounding) {
  EXPECT_THAT(labels(linear_ticks(0, 0.1 + 0.2, 0.1)), ElementsAre("0", "0.1", "0.2", "0.3"));
  EXPECT_THAT(labels(linear_ticks(-5, 5, 2.5)), ElementsAre("−5", "−2.5", "0", "2.5", "5"));
}

TEST(Ticks, LabelsHaveFourDigitsAtMostAndATrueMinus) {
  EXPECT_EQ(tick_label(-0.0), "0");
  EXPECT_EQ(tick_label(-12), "−12");
  EXPECT_EQ(tick_label(2500), "2500");
  EXPECT_EQ(tick_label(12.5), "12.5");
  EXPECT_EQ(tick_label(0.0025), "0.0025");
  EXPECT_EQ(tick_label(0.1 + 0.2), "0.3");
  EXPECT_EQ(tick_label(20000), "2×10^{4}");
  EXPECT_EQ(tick_label(-2.5e-7), "−2.5×10^{−7}");
}

TEST(Ticks, NoTwoLabelsOfAnAxisAreAlike) {
  for (const double about : {1.0, 1234.5, 0.02, -7e6, 3e-7})
    for (const double span : {1e-1, 1e-3, 1e-5, 1e-7}) {
      const double low = about, high = about + std::abs(about) * span;
      std::set<std::string> labels;
      const std::vector<Tick> ticks = linear_ticks(low, high, tick_step(low, high, 6));
      for (const Tick& tick : ticks) labels.insert(tick.label);
      EXPECT_EQ(labels.size(), ticks.size()) << about << ' ' << span;
    }
}

TEST(Ticks, ALogarithmicAxisHasItsDecades) {
  const auto ticks = logarithmic_ticks(0.1, 100, 6);
  std::vector<std::string> named;
  std::size_t minor = 0;
  for (const Tick& tick : ticks) {
    if (tick.label.empty())
      ++minor;
    else
      named.push_back(tick.label);
  }
  EXPECT_THAT(named, ElementsAre("0.1", "1", "10", "100"));
  EXPECT_EQ(minor, 24u);
  EXPECT_THAT(labels(logarithmic_ticks(1, 9, 6)), ElementsAre("1", "2", "", "", "5", "", "", "", ""));
  for (const Tick& tick : logarithmic_ticks(1e-9, 1e9, 6))
    EXPECT_TRUE(tick.label.empty() || tick.label.substr(0, 4) == "10^{") << tick.label;
}

TEST(Ticks, AStepIsTheSmallestThatLeavesNoMoreThanAsked) {
  for (const double low : {-3.0, 0.0, 0.7})
    for (const double span : {0.9, 3.3, 6.0, 47.0, 1e5})
      for (const int most : {2, 3, 5, 7, 9}) {
        const double step = tick_step(low, low + span, most);
        EXPECT_LE(linear_ticks(low, low + span, step).size(), static_cast<std::size_t>(most));
        for (int e = -3; e <= 6; ++e)
          for (const double mantissa : {1.0, 2.0, 2.5, 5.0}) {
            const double smaller = mantissa * std::pow(10.0, e);
            if (smaller >= step * 0.999 || span / smaller > 900) continue;
            EXPECT_GT(linear_ticks(low, low + span, smaller).size(), static_cast<std::size_t>(most))
                << low << ' ' << span << ' ' << most << ' ' << smaller;
          }
      }
  EXPECT_EQ(tick_step(1, 1, 5), 1);
  EXPECT_EQ(tick_step(0, HUGE_VAL, 5), 1);
}

TEST(Ticks, AreAThousandAtMost) {
  EXPECT_EQ(linear_ticks(0, 999, 1).size(), 1000u);
  EXPECT_EQ(linear_ticks(0, 5000, 1).size(), 1000u);
  EXPECT_TRUE(linear_ticks(0.1, 0.9, 1).empty());
  EXPECT_EQ(linear_ticks(2, 3, 0.5).front().value, 2);
  EXPECT_EQ(linear_ticks(2, 3, 0.5).back().value, 3);
}

TEST(XRange, GoesALittleBeyondErrorBars) {
  Panel panel;
  panel.curves.resize(2);
  panel.curves[0].x = {10, 20}, panel.curves[0].y = {1, 2};
  panel.curves[1].x = {10, 10, 20, 20}, panel.curves[1].y = {0, 2, 1, 3};
  EXPECT_EQ(x_range(panel).high, 20);
  panel.curves[1].role = "measured";
  EXPECT_NEAR(x_range(panel).low, 9.7, 1e-12);
  EXPECT_NEAR(x_range(panel).high, 20.3, 1e-12);
}

TEST(Ticks, OfOneAxisHaveTheSameForm) {
  EXPECT_THAT(labels(linear_ticks(0, 0.0013, 0.00025)),
              ElementsAre("0", "0.00025", "0.0005", "0.00075", "0.001", "0.00125"));
  EXPECT_THAT(labels(linear_ticks(-5000, 10000, 5000)),
              ElementsAre("−5×10^{3}", "0", "5×10^{3}", "1×10^{4}"));
}

TEST(Ticks, LabelsChangeTheirFormAtTheSameNumbersOnBothSides) {
  EXPECT_EQ(tick_label(9999), "9999");
  EXPECT_EQ(tick_label(10000), "1×10^{4}");
  EXPECT_EQ(tick_label(-9999), "−9999");
  EXPECT_EQ(tick_label(0.001), "0.001");
  EXPECT_EQ(tick_label(0.00123), "0.00123");
  EXPECT_EQ(tick_label(0.0009), "9×10^{−4}");
  EXPECT_EQ(tick_label(12.34), "12.34");
  EXPECT_EQ(tick_label(123.4), "123.4");
  EXPECT_EQ(tick_label(1.234), "1.234");
  EXPECT_EQ(tick_label(0.1234), "0.123");
  EXPECT_EQ(tick_label(0.01234), "0.0123");
  EXPECT_EQ(tick_label(100), "100");
  EXPECT_EQ(tick_label(1.25e5), "1.25×10^{5}");
  EXPECT_EQ(tick_label(1000), "1000");
}

TEST(Ticks, OfALogarithmicAxisStandAtDigitsTimesPowersOfTen) {
  const auto named = [](double low, double high, int most) {
    std::vector<std::string> texts;
    for (const Tick& tick : logarithmic_ticks(low, high, most))
      if (!tick.label.empty()) texts.push_back(tick.label);
    return texts;
  };
  EXPECT_THAT(named(0.3, 30, 6), ElementsAre("0.5", "1", "2", "5", "10", "20"));
  EXPECT_THAT(named(1, 100, 6), ElementsAre("1", "10", "100"));
  EXPECT_THAT(named(1.1, 99, 6), ElementsAre("2", "5", "10", "20", "50"));
  EXPECT_THAT(named(0.01, 1000, 9), ElementsAre("0.01", "0.1", "1", "10", "100", "1000"));
  EXPECT_THAT(named(0.9e-2, 10, 9), ElementsAre("0.01", "0.1", "1", "10"));
  EXPECT_THAT(named(0.9e-3, 1, 9), ElementsAre("0.001", "0.01", "0.1", "1"));
  EXPECT_THAT(named(5e-4, 0.02, 9), ElementsAre("0.0005", "0.001", "0.002", "0.005", "0.01", "0.02"));
  EXPECT_THAT(named(2e-5, 4e-4, 9), ElementsAre("2×10^{−5}", "5×10^{−5}", "10^{−4}", "2×10^{−4}"));
  EXPECT_THAT(named(1, 9000, 9), ElementsAre("1", "10", "100", "1000"));
  EXPECT_THAT(named(1, 11000, 9), ElementsAre("10^{0}", "10^{1}", "10^{2}", "10^{3}", "10^{4}"));
  EXPECT_THAT(named(1e-4, 1, 6), ElementsAre("10^{−4}", "10^{−3}", "10^{−2}", "10^{−1}", "10^{0}"));
  EXPECT_THAT(named(1, 1e5, 6), ElementsAre("10^{0}", "10^{1}", "10^{2}", "10^{3}", "10^{4}", "10^{5}"));
  // Thinned: every second of eleven.
  EXPECT_THAT(named(1, 1e10, 6), ElementsAre("10^{0}", "10^{2}", "10^{4}", "10^{6}", "10^{8}", "10^{10}"));
  EXPECT_THAT(named(1, 1e6, 6), ElementsAre("10^{0}", "10^{2}", "10^{4}", "10^{6}"));
  const auto ticks = logarithmic_ticks(1, 100, 6);
  ASSERT_EQ(ticks.size(), 19u);
  EXPECT_EQ(ticks[8].value, 9);
  EXPECT_EQ(ticks[10].value, 20);
  // Unlabelled ticks go once they are too many to be told apart.
  EXPECT_EQ(logarithmic_ticks(1, 1e11, 6).size(), 12 + 11 * 8u);
  EXPECT_EQ(logarithmic_ticks(1, 1e12, 6).size(), 5u);
}

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

TEST(YRange, TakesTheStepThatGivesAwayLeast) {
  EXPECT_THAT(y_axis({-0.45, 0.95}), ElementsAre(-0.5, 1, 0.5));
  EXPECT_THAT(y_axis({0, 3.9}), ElementsAre(0, 4, 2));
  EXPECT_THAT(y_axis({0, 4.9}), ElementsAre(0, 5, 1));
  EXPECT_THAT(y_axis({-4.9, 0}), ElementsAre(-5, 0, 1));
  EXPECT_THAT(y_axis({11.2, 13.8}), ElementsAre(11, 14, 1));
}

TEST(YRange, HasThreeToSixTicksWhereItEndsAtThem) {
  for (double low = -9.7; low < 10; low += 0.83)
    for (double span = 0.11; span < 3000; span *= 1.31) {
      const std::vector<double> range = y_axis({low, low + span});
      EXPECT_LE(range[0], low);
      EXPECT_GE(range[1], low + span);
      const double from = low >= 0 && low < 0.6 * span ? 0 : low,
                   to = low + span <= 0 && -low - span < 0.6 * span ? 0 : low + span;
      EXPECT_LE(range[1] - range[0], 1.2501 * (to - from)) << low << ' ' << span;
      if (range[2] == 0) {
        EXPECT_NEAR(range[0], from == 0 ? 0 : low - 0.05 * span, 1e-9 * span);
        EXPECT_NEAR(range[1], to == 0 ? 0 : low + 1.05 * span, 1e-9 * span);
        continue;
      }
      const double ticks = (range[1] - range[0]) / range[2] + 1;
      EXPECT_NEAR(ticks, std::round(ticks), 1e-6);
      EXPECT_GE(ticks, 2.9);
      EXPECT_LE(ticks, 6.1);
      EXPECT_NEAR(range[0] / range[2], std::round(range[0] / range[2]), 1e-6);
      if (range[0] != 0) {
        EXPECT_GE(low - range[0], 0.0099 * span);
      }
      if (range[1] != 0) {
        EXPECT_GE(range[1] - low - span, 0.0099 * span);
      }
    }
}

TEST(YRange, OfALogarithmicAxisIsATwentiethOfItsRatioMore) {
  Panel panel = panel_of({0, 1, 2}, {1, 100, -5});
  panel.y.logarithmic = true;
  AxisRange range = y_range(panel, x_range(panel));
  EXPECT_NEAR(range.low, std::pow(100, -0.05), 1e-12);
  EXPECT_NEAR(range.high, std::pow(100, 1.05), 1e-9);
  EXPECT_TRUE(range.logarithmic);
  panel.curves[0].y = {7, 7, 7};
  range = y_range(panel, x_range(panel));
  EXPECT_NEAR(range.low, 3.5 * std::pow(4, -0.05), 1e-12);
  EXPECT_NEAR(range.high, 14 * std::pow(4, 0.05), 1e-12);
  panel.curves[0].y = {-1, 0, none};
  range = y_range(panel, x_range(panel));
  EXPECT_NEAR(range.low, std::pow(10, -0.05), 1e-12);
  EXPECT_NEAR(range.high, std::pow(10, 1.05), 1e-12);
}

TEST(YRange, AsAskedForMeansNoRounding) {
  Panel panel = panel_of({0, 1}, {0.5, 3.9});
  panel.y.step = 1;
  const AxisRange stepped = y_range(panel, x_range(panel));
  EXPECT_EQ(stepped.low, 0);
  EXPECT_DOUBLE_EQ(stepped.high, 3.9 + 0.05 * 3.4);
  EXPECT_EQ(stepped.step, 0);
  panel.y.step = 0;
  for (double Axis::*end : {&Axis::low, &Axis::high}) {
    Panel one = panel;
    one.y.*end = end == &Axis::low ? -1 : 7;
    EXPECT_EQ(y_range(one, x_range(one)).step, 0);
  }
  panel.y.low = 7, panel.y.high = -2;  // the wrong way round
  EXPECT_EQ(y_range(panel, x_range(panel)).low, -2);
  EXPECT_EQ(y_range(panel, x_range(panel)).high, 7);
  panel.y.low = panel.y.high = 5;
  EXPECT_EQ(y_range(panel, x_range(panel)).low, 4.5);
  EXPECT_EQ(y_range(panel, x_range(panel)).high, 5.5);
}

TEST(XRange, OfMarkersOneValueAndNone) {
  Panel panel = panel_of({2, 4}, {0, 1});
  panel.markers = {{7.03, "", "drive"}};
  EXPECT_EQ(x_axis(panel)[1], 7.03);
  EXPECT_THAT(x_axis(panel_of({5, 5}, {0, 1})), ElementsAre(4.5, 5.5));
  EXPECT_THAT(x_axis(panel_of({-5}, {0})), ElementsAre(-5.5, -4.5));
  EXPECT_THAT(x_axis(panel_of({0}, {0})), ElementsAre(-1, 1));
  EXPECT_THAT(x_axis(panel_of({}, {})), ElementsAre(0, 1));
  EXPECT_THAT(x_axis(panel_of({1, 2, 1e300, -1e300, 3, none}, {})), ElementsAre(1, 3));
  Panel stepped = panel_of({0, 2.99}, {0, 1});
  stepped.x.step = 3;
  EXPECT_EQ(x_axis(stepped)[1], 3);
  stepped.x.step = 7;
  EXPECT_EQ(x_axis(stepped)[1], 2.99);
  Panel log = panel_of({3, 3}, {0, 1});
  log.x.logarithmic = true;
  EXPECT_THAT(x_axis(log), ElementsAre(1.5, 6));
  log.x.high = -4;  // which it cannot end at
  EXPECT_THAT(x_axis(log), ElementsAre(1.5, 6));
  log.curves[0].x = {none};
  EXPECT_THAT(x_axis(log), ElementsAre(1, 10));
}

TEST(YRange, HoldsWhatIsInSightUpToTheVeryEnds) {
  Panel panel = panel_of({0, 1, 2, 3}, {50, 1, 2, -70});
  panel.x.low = 1, panel.x.high = 2;
  const AxisRange range = y_range(panel, x_range(panel));
  EXPECT_LT(range.low, 1);
  EXPECT_GT(range.low, 0.5);
  EXPECT_LT(range.high, 2.5);
  panel.x.low = 0, panel.x.high = 3;
  EXPECT_LT(y_range(panel, x_range(panel)).low, -70);
  EXPECT_GT(y_range(panel, x_range(panel)).high, 50);
  panel.curves[0].x.push_back(1.5);  // without a y
  EXPECT_GT(y_range(panel, x_range(panel)).high, 50);
}

TEST(PhasePortrait, GetsATenthOfRoomOnLogarithmicAxesToo) {
  Panel panel = panel_of({1, 100}, {-3, 1});
  panel.phase_portrait = true;
  panel.x.logarithmic = true;
  const AxisRange x = x_range(panel);
  EXPECT_NEAR(x.low, std::pow(100, -0.05), 1e-12);
  EXPECT_NEAR(x.high, std::pow(100, 1.05), 1e-9);
  EXPECT_DOUBLE_EQ(y_range(panel, x).low, -3.3);
  EXPECT_DOUBLE_EQ(y_range(panel, x).high, 3.3);
  panel.curves[0].y = {0, 4};
  EXPECT_DOUBLE_EQ(y_range(panel, x).low, -0.2);
  panel.curves[0].y = {-4, 0};
  EXPECT_DOUBLE_EQ(y_range(panel, x).high, 0.2);
}

TEST(TicksOf, AreAsAskedForUpToAHundred) {
  Axis axis;
  axis.step = 0.5;
  EXPECT_EQ(ticks_of(axis, {0, 10, false, 0, 1, 0}, 5).size(), 21u);
  EXPECT_EQ(ticks_of(axis, {0, 49.9, false, 0, 1, 0}, 5).size(), 100u);
  EXPECT_LE(ticks_of(axis, {0, 50, false, 0, 1, 0}, 5).size(), 5u);
  axis.step = 0;
  EXPECT_EQ(ticks_of(axis, {0, 10, false, 0, 1, 0}, 5).size(), 5u);
  EXPECT_EQ(ticks_of(axis, {1, 100, true, 0, 1, 0}, 5).size(), 19u);
}

TEST(AxisRange, LogarithmicPlacesAreNoneBelowZero) {
  const AxisRange range{1, 100, true, 10, 30, 0};
  EXPECT_TRUE(std::isnan(range.px(-1)));
  EXPECT_DOUBLE_EQ(range.px(10), 20);
  EXPECT_DOUBLE_EQ(AxisRange({1, 3, false, 10, 30, 0}).px(1.5), 15);
}

TEST(XRange, IsThatOfVerySmallAndVeryLargeNumbersToo) {
  EXPECT_THAT(x_axis(panel_of({1e-200, 2e-200}, {0, 1})), ElementsAre(1e-200, 2e-200));
  EXPECT_THAT(x_axis(panel_of({-2e-9, 1e-9}, {0, 1})), ElementsAre(-2e-9, 1e-9));
  EXPECT_DOUBLE_EQ(x_axis(panel_of({1e200, 2.2e200}, {0, 1}))[1], 2.2e200);
  const double close = 1e9 * (1 + 1e-13);  // no more than rounding
  EXPECT_NEAR(x_axis(panel_of({1e9, close}, {0, 1}))[0], 0.9e9, 1);
  EXPECT_NEAR(x_axis(panel_of({-1e9, -close}, {0, 1}))[1], -0.9e9, 1);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
