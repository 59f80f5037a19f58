#include "cromer/model/between_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cromer::core {
namespace CROMER_FILE {

TEST(BandLimited, KeepsTheSamplesAndConstants) {
  const std::vector<double> samples{1, 4, -2, 7, 0, 3};
  const auto fine = refine_band_limited(samples, 16);
  ASSERT_EQ(fine.size(), 81u);
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_EQ(fine[16 * i], samples[i]);
  for (const double value : refine_band_limited(std::vector<double>(40, 2.5), 8))
    EXPECT_NEAR(value, 2.5, 1e-14);
}

TEST(BandLimited, FindsTheSinusoidBetweenItsSamples) {
  // Up to 3/4 of the Nyquist frequency, where straight lines miss it by the amplitude itself.
  for (const double share : {0.05, 0.4, 0.75}) {
    const double w = share * std::numbers::pi;
    std::vector<double> samples(100);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = std::cos(w * static_cast<double>(i) + 0.3);
    const auto fine = refine_band_limited(samples, 16);
    for (std::size_t j = 20 * 16; j < 80 * 16; ++j)
      EXPECT_NEAR(fine[j], std::cos(w * static_cast<double>(j) / 16 + 0.3), 2e-4) << share << ' ' << j;
  }
}

TEST(BandLimited, ReachesCloserToTheNyquistFrequencyWithMoreSamples) {
  const double w = 31.0 / 32 * std::numbers::pi;
  std::vector<double> samples(400);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = std::cos(w * static_cast<double>(i) + 0.3);
  const auto off = [&](int reach) {
    const auto fine = refine_band_limited(samples, 16, reach);
    double most = 0;
    for (std::size_t j = 140 * 16; j < 260 * 16; ++j)
      most = std::max(most, std::abs(fine[j] - std::cos(w * static_cast<double>(j) / 16 + 0.3)));
    return most;
  };
  EXPECT_LT(off(128), 2e-4);
  EXPECT_GT(off(16), 0.1);
}

TEST(BandLimited, BesselFunction) {
  EXPECT_DOUBLE_EQ(bessel_i0(0), 1);
  EXPECT_NEAR(bessel_i0(1) / 1.2660658777520084, 1, 1e-15);
  EXPECT_NEAR(bessel_i0(8) / 427.56411572180474, 1, 2e-15);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
