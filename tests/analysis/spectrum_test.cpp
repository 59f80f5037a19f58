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

TEST(Spectrum, ConstantHasNoLine) {
  EXPECT_FALSE(strongest_line(amplitude_spectrum(std::vector<double>(100, 2.0), 0.01)).has_value());
}

}  // namespace
}  // namespace cromer
