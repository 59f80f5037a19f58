#include "cromer/analysis/textbook_damping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "cromer/model/sensor.h"

namespace cromer {
namespace {

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

}  // namespace
}  // namespace cromer
