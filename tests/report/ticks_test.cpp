#include "cromer/report/ticks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace cromer::core {
namespace {

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
  EXPECT_THAT(named(0.9e-3, 1, 9), ElementsAre("10^{−3}", "10^{−2}", "10^{−1}", "10^{0}"));
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

}  // namespace
}  // namespace cromer::core
