#include "cromer/analysis/envelope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace cromer::core {
namespace CROMER_FILE {

TEST(Envelope, follows_the_amplitude_of_a_decaying_swing) {
  std::vector<double> t, x;
  for (int i = 0; i <= 4000; ++i) {
    t.push_back(0.01 * i);
    x.push_back(2 * std::exp(-0.05 * t.back()) * std::cos(6 * t.back()));
  }
  const Envelope found = envelope(t, x);
  // 40 s hold 38.2 periods; the release at t = 0 is a turning point.
  ASSERT_EQ(found.top.size(), 39u);
  ASSERT_EQ(found.bottom.size(), 38u);
  EXPECT_EQ(found.top_t.front(), 0);
  for (std::size_t i = 0; i < found.top.size(); ++i) {
    // A turning point lies atan(0.05/6) of phase before the touching point; its height is exact to cos of
    // that.
    EXPECT_NEAR(found.top[i], 2 * std::exp(-0.05 * found.top_t[i]), 1e-4) << found.top_t[i];
    EXPECT_NEAR(found.top_t[i], (2 * M_PI * static_cast<double>(i) - (i > 0 ? std::atan(0.05 / 6) : 0)) / 6,
                1e-5);
  }
  for (std::size_t i = 0; i < found.bottom.size(); ++i)
    EXPECT_NEAR(found.bottom[i], -2 * std::exp(-0.05 * found.bottom_t[i]), 1e-4);
}

TEST(Envelope, too_few_samples_have_none) {
  const std::vector<double> two{0, 1};
  EXPECT_TRUE(envelope(two, two).top.empty());
}

/// Samples 1 s apart from t = 5 s on, and after them what must not be read.
Envelope of(std::vector<double> x) {
  const std::size_t n = x.size();
  std::vector<double> t;
  for (std::size_t i = 0; i < n; ++i) t.push_back(5 + static_cast<double>(i));
  t.insert(t.end(), {6 + static_cast<double>(n), 7 + static_cast<double>(n)});
  x.insert(x.end(), {-100, 100});
  return envelope(std::span(t).first(n), std::span(x).first(n));
}

TEST(Envelope, OfThreeSamplesTheMiddleOneMayTurn) {
  // Through (-1, 1), (0, 3), (1, 2): 3 + u/2 - 3 u^2/2.
  const Envelope high = of({1, 3, 2}), low = of({-1, -3, -2});
  ASSERT_EQ(high.top.size(), 1u);
  EXPECT_NEAR(high.top_t[0], 6 + 1.0 / 6, 1e-15);
  EXPECT_NEAR(high.top[0], 3 + 1.0 / 24, 1e-15);
  EXPECT_TRUE(high.bottom.empty());
  ASSERT_EQ(low.bottom.size(), 1u);
  EXPECT_NEAR(low.bottom_t[0], 6 + 1.0 / 6, 1e-15);
  EXPECT_NEAR(low.bottom[0], -3 - 1.0 / 24, 1e-15);
  EXPECT_TRUE(low.top.empty());
}

TEST(Envelope, AnExtremeAtTheLastSampleButOneCountsAndOneAtTheLastDoesNot) {
  const Envelope found = of({0, 2, 0, -3, -1});
  EXPECT_EQ(found.top.size(), 1u);
  ASSERT_EQ(found.bottom.size(), 1u);
  EXPECT_NEAR(found.bottom_t[0], 8.1, 1e-14);
  EXPECT_TRUE(of({0, 1, 2}).top.empty());
  EXPECT_TRUE(of({0, -1, -2}).bottom.empty());
}

TEST(Envelope, OfTwoEqualHighestSamplesTheFirstCounts) {
  const Envelope high = of({0, 2, 2, 0}), low = of({0, -2, -2, 0});
  ASSERT_EQ(high.top.size(), 1u);
  EXPECT_NEAR(high.top_t[0], 6.5, 1e-15);
  EXPECT_NEAR(high.top[0], 2.25, 1e-15);
  ASSERT_EQ(low.bottom.size(), 1u);
  EXPECT_NEAR(low.bottom_t[0], 6.5, 1e-15);
}

TEST(Envelope, AReleaseCountsOnlyWhereTheMotionFallsBackToZero) {
  EXPECT_EQ(of({2, 1.8, 1.2}).top, std::vector<double>{2});
  EXPECT_EQ(of({2, 1.8, 1.2}).top_t, std::vector<double>{5});
  EXPECT_EQ(of({-2, -1.8, -1.2}).bottom, std::vector<double>{-2});
  // In the middle of a swing the first sample is no turning point.
  for (const auto& moving : {std::vector<double>{2, 1, 0}, {2, 1.4, 0.6}, {2, 1, 0.5}})
    EXPECT_TRUE(of(moving).top.empty());
  EXPECT_TRUE(of({-2, -1.4, -0.6}).bottom.empty());
  for (const auto& none : {std::vector<double>{0, -1, -2}, {0, 1, 2}, {1, 1, 1}, {-1, -1, -1}, {1, 2, 3}}) {
    EXPECT_TRUE(of(none).top.empty());
    EXPECT_TRUE(of(none).bottom.empty());
  }
}

TEST(Envelope, UnequalSpacesGiveTheParabolaOfTheSamples) {
  // x = 7 - (t - 3)^2
  const std::vector<double> t{1, 2.5, 6}, x{3, 6.75, -2};
  const Envelope found = envelope(t, x);
  ASSERT_EQ(found.top.size(), 1u);
  EXPECT_NEAR(found.top_t[0], 3, 1e-14);
  EXPECT_NEAR(found.top[0], 7, 1e-14);
}

TEST(Interpolate, between_and_beyond) {
  const std::vector<double> at{1, 2, 4}, values{10, 20, 0};
  EXPECT_EQ(interpolate(at, values, 0), 10);
  EXPECT_EQ(interpolate(at, values, 1.5), 15);
  EXPECT_EQ(interpolate(at, values, 3), 10);
  EXPECT_EQ(interpolate(at, values, 9), 0);
  EXPECT_EQ(interpolate(at, values, 1), 10);
  EXPECT_EQ(interpolate(at, values, 2), 20);
  EXPECT_EQ(interpolate(at, values, 4), 0);
  EXPECT_EQ(interpolate(std::vector{3.0}, std::vector{7.0}, 1), 7);
  EXPECT_EQ(interpolate(std::vector{3.0}, std::vector{7.0}, 3), 7);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
