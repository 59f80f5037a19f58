#include "cromer/analysis/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace cromer {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

std::vector<double> sinusoid(std::size_t n, double h, double w, double A, double phase) {
  std::vector<double> y(n);
  for (std::size_t i = 0; i < n; ++i) y[i] = 3 + A * std::cos(w * static_cast<double>(i) * h + phase);
  return y;
}

TEST(Spectrum, LineHasItsFrequencyAndAmplitude) {
  const double h = 0.01;
  for (std::size_t n : {500u, 1024u, 5000u})
    for (double cycles : {10.0, 10.3, 40.5, 77.77})
      for (double phase : {0.0, 1.0, 2.5}) {
        const double resolution = two_pi / (static_cast<double>(n) * h), w = cycles * resolution;
        const auto line = strongest_line(amplitude_spectrum(sinusoid(n, h, w, 0.04, phase), h));
        ASSERT_TRUE(line.has_value());
        EXPECT_NEAR(line->angular_frequency, w, 0.03 * resolution) << n << ' ' << cycles;
        EXPECT_NEAR(line->amplitude, 0.04, 0.05 * 0.04);
      }
}

TEST(Spectrum, LineStandsAboveDriftAndNoise) {
  std::vector<double> y = sinusoid(4000, 0.01, 9, 0.02, 0.3);
  std::mt19937_64 engine(1);
  std::normal_distribution<double> normal(0, 0.02);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += normal(engine) + 5e-5 * static_cast<double>(i);
  const auto line = strongest_line(amplitude_spectrum(y, 0.01));
  ASSERT_TRUE(line.has_value());
  EXPECT_NEAR(line->angular_frequency, 9, 0.02);
}

TEST(Spectrum, OfLeastSquaresIsTheSameAtEvenTimes) {
  const double h = 0.01, w = 9;
  const std::vector<double> y = sinusoid(3000, h, w, 0.04, 0.7);
  std::vector<double> t(y.size());
  for (std::size_t i = 0; i < t.size(); ++i) t[i] = 5 + static_cast<double>(i) * h;
  const auto even = strongest_line(amplitude_spectrum(y, h)),
             any = strongest_line(least_squares_spectrum(t, y, h));
  ASSERT_TRUE(even && any);
  EXPECT_NEAR(any->angular_frequency, even->angular_frequency, 1e-2 * two_pi / (3000 * h));
  EXPECT_NEAR(any->amplitude, 0.04, 0.02 * 0.04);
}

// Every other period is missing: half the frequency stands out too, but less.
TEST(Spectrum, OfLeastSquaresHoldsAcrossGaps) {
  const double h = 0.01, w = 6;
  const std::vector<double> all = sinusoid(4000, h, w, 0.04, 0.7);
  std::vector<double> t, y;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (std::fmod(w * static_cast<double>(i) * h, 2 * two_pi) < two_pi) {
      t.push_back(static_cast<double>(i) * h);
      y.push_back(all[i]);
    }
  const auto lines = strongest_lines(least_squares_spectrum(t, y, h), 0.3, 8);
  ASSERT_GT(lines.size(), 1u);
  EXPECT_NEAR(lines[0].angular_frequency, w, 0.05 * two_pi / 40);
  EXPECT_NEAR(lines[0].amplitude, 0.04, 0.02 * 0.04);
  EXPECT_LT(lines[1].amplitude, 0.95 * lines[0].amplitude);
}

TEST(Spectrum, ConstantHasNoLine) {
  EXPECT_FALSE(strongest_line(amplitude_spectrum(std::vector<double>(100, 2.0), 0.01)).has_value());
}

}  // namespace
}  // namespace cromer
