#include "cromer/analysis/textbook_damping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "cromer/model/sensor.h"

namespace cromer::core {
namespace CROMER_FILE {

struct Decay {
  std::vector<double> t, y;
};

Decay decay(double g, double w, double duration, double noise = 0) {
  Decay record;
  NormalDeviates normal(3);
  for (int i = 0; i <= static_cast<int>(duration * 100); ++i) {
    const double t = i / 100.0;
    record.t.push_back(t);
    record.y.push_back(std::exp(-g * t) * std::cos(w * t) + noise * normal.next());
  }
  return record;
}

TEST(PeakDecrement, IsExactWithoutNoise) {
  const double g = 0.05, w = 6, period = 2 * std::numbers::pi / w;
  const Decay record = decay(g, w, 40);
  const auto found = peak_decrement(record.t, record.y, period, 0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->value, g * period, 1e-4 * g * period);
  EXPECT_EQ(found->peaks, 38);
}

TEST(PeakDecrement, NoiseMakesItTooLow) {
  const double g = 0.05, w = 6, period = 2 * std::numbers::pi / w;
  const Decay record = decay(g, w, 60, 0.02);
  const auto found = peak_decrement(record.t, record.y, period, 0.02);
  ASSERT_TRUE(found);
  EXPECT_LT(found->value, g * period - 2 * found->standard_error);
  EXPECT_GT(found->value, 0.7 * g * period);
  EXPECT_FALSE(peak_decrement(record.t, record.y, period, 10));
}

TEST(HalfPowerBandwidth, IsTwiceTheDecayRateOfASwingSeenToItsEnd) {
  const Decay record = decay(0.1, 6, 100);
  const auto found = half_power_bandwidth(record.t, record.y, 6.01);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->width, 0.2, 0.002);
  EXPECT_NEAR(found->angular_frequency, 6, 0.002);
}

TEST(HalfPowerBandwidth, IsTheRecordsOwnOfAnUndampedLine) {
  const Decay record = decay(0, 6, 50);
  const auto found = half_power_bandwidth(record.t, record.y, 6);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->width, found->narrowest, 0.01 * found->narrowest);
  EXPECT_NEAR(found->narrowest, 0.886 * 2 * std::numbers::pi / 50, 1e-3 * found->narrowest);
}

/// Peaks with these heights at 10 s, 11 s, ..., each the vertex of x = height - 40 u^2 cut off at 0, 0.05 s
/// from one sample to the next.
Decay peaks(const std::vector<double>& heights, double late = 0) {
  Decay record;
  for (std::size_t i = 0; i < 20 * heights.size(); ++i) {
    const double t = 9.5 + 0.05 * static_cast<double>(i);
    const std::size_t k = i / 20;
    const double u = t - (10 + static_cast<double>(k) + late);
    record.t.push_back(t);
    record.y.push_back(std::max(0.0, heights[k] * (1 - 16 * u * u)));
  }
  // The window of the last one ends after the last sample.
  record.t.push_back(9.5 + static_cast<double>(heights.size()) + 0.05);
  record.y.push_back(0);
  return record;
}

TEST(PeakDecrement, IsTheSlopeOfTheLogarithms) {
  // Logarithms 0, -0.7, -2: slope -1, residuals -0.1, 0.2, -0.1.
  for (const double late : {0.0, 0.02, -0.01}) {
    const Decay record = peaks({1, std::exp(-0.7), std::exp(-2)}, late);
    const auto found = peak_decrement(record.t, record.y, 1, 0);
    ASSERT_TRUE(found) << late;
    EXPECT_EQ(found->peaks, 3);
    EXPECT_NEAR(found->value, 1, 1e-12) << late;
    EXPECT_NEAR(found->standard_error, std::sqrt(0.06 / 1 / 2), 1e-12) << late;
  }
  const Decay four = peaks({1, 0.5, 0.25, 0.125});
  const auto found = peak_decrement(four.t, four.y, 1, 0);
  EXPECT_EQ(found->peaks, 4);
  EXPECT_NEAR(found->value, std::numbers::ln2, 1e-12);
  EXPECT_NEAR(found->standard_error, 0, 1e-12);
}

TEST(PeakDecrement, EndsAtFourTimesTheNoise) {
  const Decay record = peaks({1, 0.5, 0.25, 0.125, 1, 1});
  EXPECT_EQ(peak_decrement(record.t, record.y, 1, 0.0624)->peaks, 3);
  EXPECT_FALSE(peak_decrement(record.t, record.y, 1, 0.0626));
  EXPECT_FALSE(peak_decrement({}, {}, 1, 0));
}

TEST(PeakDecrement, OfThreePeaksThereIsOneOfTwoNone) {
  const Decay two = peaks({1, 0.5}), three = peaks({1, 0.5, 0.25});
  EXPECT_FALSE(peak_decrement(two.t, two.y, 1, 0));
  EXPECT_TRUE(peak_decrement(three.t, three.y, 1, 0));
}

TEST(HalfPowerBandwidth, TakesTimesThatAreNotEquallySpaced) {
  const double g = 0.1, w = 6;
  std::vector<double> t, y;
  for (double at = 7; at < 107; at += 0.01 + 0.015 * std::pow(std::sin(at), 2)) {
    t.push_back(at);
    y.push_back(std::exp(-g * (at - 7)) * std::sin(w * (at - 7)));
  }
  const auto found = half_power_bandwidth(t, y, 5.99);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->width, 2 * g, 0.002);
  EXPECT_NEAR(found->angular_frequency, w, 0.002);
  EXPECT_NEAR(found->narrowest, 0.886 * 2 * std::numbers::pi / 100, 1e-4);
}

TEST(HalfPowerBandwidth, IsFoundFromTwoNarrowestLinesAway) {
  const Decay record = decay(0, 6, 50);
  const double narrowest = 5.566 / 50;
  for (const double off : {-1.9, -1.0, 0.4, 1.9}) {
    const auto found = half_power_bandwidth(record.t, record.y, 6 + off * narrowest);
    ASSERT_TRUE(found) << off;
    EXPECT_NEAR(found->angular_frequency, 6, 0.002) << off;
  }
}

TEST(HalfPowerBandwidth, OfALineThatDoesNotFallOnBothSidesIsNone) {
  const Decay slow = decay(3, 2, 10);
  EXPECT_FALSE(half_power_bandwidth(slow.t, slow.y, 2));
  Decay few = decay(0.1, 6, 40);
  few.t.resize(7);
  few.y.resize(7);
  EXPECT_FALSE(half_power_bandwidth(few.t, few.y, 6));
  const std::vector<double> t{0, 1, 2, 3, 4, 5, 6, 7}, y{1, 0, -1, 0, 1, 0, -1, 0};
  EXPECT_TRUE(half_power_bandwidth(t, y, std::numbers::pi / 2)) << "eight are enough";
}

TEST(HalfPowerBandwidth, MeasuresEachSideOfALineThatLeans) {
  // A weaker line a little above it: the upper side falls slower.
  Decay record = decay(0.1, 6, 100);
  for (std::size_t i = 0; i < record.t.size(); ++i)
    record.y[i] += 0.4 * std::exp(-0.1 * record.t[i]) * std::cos(6.15 * record.t[i]);
  const auto power = [&](double w) {
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < record.t.size(); ++i) sum += std::polar(record.y[i], -w * record.t[i]);
    return std::norm(sum);
  };
  double top = 5.9;
  for (double w = 5.9; w < 6.2; w += 1e-3)
    if (power(w) > power(top)) top = w;
  const auto side = [&](double step) {
    double w = top;
    while (power(w) > 0.5 * power(top)) w += step;
    return std::abs(w - top);
  };
  ASSERT_GT(side(1e-3), 1.3 * side(-1e-3));
  const auto found = half_power_bandwidth(record.t, record.y, 6);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->width, side(1e-3) + side(-1e-3), 0.003);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
