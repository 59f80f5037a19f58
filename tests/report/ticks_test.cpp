#include "cromer/report/ticks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace cromer {
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

}  // namespace
}  // namespace cromer
