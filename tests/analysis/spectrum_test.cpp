#include "cromer/analysis/spectrum.h"
#include "cromer/base/pi.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace cromer::core {
namespace CROMER_FILE {

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

std::vector<double> noise(std::size_t n) {
  std::mt19937_64 engine(2);
  std::normal_distribution<double> normal(3, 1);
  std::vector<double> y(n);
  for (double& value : y) value = normal(engine);
  return y;
}

TEST(Spectrum, IsTheWindowedSumWrittenOut) {
  const double h = 0.02;
  for (const auto& [count, padded] :
       {std::pair<std::size_t, std::size_t>{4, 8}, {8, 8}, {9, 16}, {100, 128}}) {
    const std::vector<double> y = noise(count);
    const auto n = static_cast<double>(count);
    double mean = 0;
    for (const double value : y) mean += value / n;
    const Spectrum found = amplitude_spectrum(y, h);
    EXPECT_NEAR(found.step * static_cast<double>(padded) * h, two_pi, 1e-14) << count;
    ASSERT_EQ(found.amplitude.size(), padded / 2 + 1) << count;
    for (std::size_t k = 0; k < found.amplitude.size(); ++k) {
      std::complex<double> sum = 0;
      for (std::size_t i = 0; i < count; ++i)
        sum += (y[i] - mean) * std::pow(std::sin(two_pi / 2 * (static_cast<double>(i) + 0.5) / n), 2) *
               std::polar(1.0, -two_pi * static_cast<double>(i * k) / static_cast<double>(padded));
      // The window's mean is one half, and half of a line is at its negative frequency.
      EXPECT_NEAR(found.amplitude[k], 4 * std::abs(sum) / n, 1e-13) << count << ' ' << k;
    }
  }
}

/// By how much mean and sinusoid of this frequency explain more than the mean alone, weighted: as an
/// amplitude.
double explained(const std::vector<double>& t, const std::vector<double>& y, double w) {
  // Gram and Schmidt: 1, cosine, sine, and the values in turn.
  const std::size_t n = t.size();
  std::vector<double> weight(n);
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    weight[i] = 1.0001 - std::cos(two_pi * (t[i] - t.front()) / (t.back() - t.front()));
    sum += weight[i];
  }
  const auto product = [&](const std::vector<double>& a, const std::vector<double>& b) {
    double all = 0;
    for (std::size_t i = 0; i < n; ++i) all += weight[i] * a[i] * b[i] / sum;
    return all;
  };
  std::vector<std::vector<double>> basis{std::vector(n, 1.0), std::vector<double>(n), std::vector<double>(n),
                                         y};
  for (std::size_t i = 0; i < n; ++i) {
    basis[1][i] = std::cos(w * t[i]);
    basis[2][i] = std::sin(w * t[i]);
  }
  for (int twice = 0; twice < 2; ++twice)
    for (std::size_t j = 1; j < 4; ++j)
      for (std::size_t k = 0; k < (j < 3 ? j : 1); ++k) {
        const double part = product(basis[j], basis[k]) / product(basis[k], basis[k]);
        for (std::size_t i = 0; i < n; ++i) basis[j][i] -= part * basis[k][i];
      }
  double power = 0;
  for (const std::size_t j : {1u, 2u})
    power += std::pow(product(basis[3], basis[j]), 2) / product(basis[j], basis[j]);
  return std::sqrt(2 * power);
}

TEST(Spectrum, OfLeastSquaresIsTheBestFitAtEveryFrequency) {
  const double h = 0.5;
  std::vector<double> t, y = noise(40);
  for (std::size_t i = 0; i < y.size(); ++i)
    t.push_back(7 + h * static_cast<double>(i + (i > 9 ? 3 : 0) + (i > 30)));
  const Spectrum found = least_squares_spectrum(t, y, h);
  EXPECT_NEAR(found.step * 256 * h, two_pi, 1e-13);
  EXPECT_EQ(found.amplitude[0], 0);
  for (std::size_t k = 1; k + 1 < found.amplitude.size(); ++k)
    EXPECT_NEAR(found.amplitude[k], explained(t, y, static_cast<double>(k) * found.step), 1e-7) << k;
  EXPECT_EQ(found.amplitude.back(), 0) << "the highest frequency has no sine";
}

TEST(Spectrum, OfLeastSquaresIsPaddedToThreeTimesTheDuration) {
  const auto size = [](double duration) {
    const std::vector<double> t{0, 1, 2, duration}, y{1, 0, 1, 0};
    return least_squares_spectrum(t, y, 1).amplitude.size();
  };
  EXPECT_EQ(size(10), 17u);  // 32 values
  EXPECT_EQ(size(10.01), 33u);
}

TEST(Spectrum, OfLeastSquaresTakesTimesOffTheGrid) {
  const double h = 0.01, w = 9;
  std::mt19937_64 engine(2);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  std::vector<double> t, y;
  for (int i = 0; i < 3000; ++i) {
    t.push_back(5 + h * (i + uniform(engine)));
    y.push_back(3 + 0.04 * std::cos(w * t.back()));
  }
  const auto line = strongest_line(least_squares_spectrum(t, y, h));
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->angular_frequency, w, 1e-2 * two_pi / 30);
  EXPECT_NEAR(line->amplitude, 0.04, 0.01 * 0.04);
}

void expect_line(const SpectralLine& line, double w, double amplitude) {
  EXPECT_NEAR(line.angular_frequency, w, 1e-14);
  EXPECT_NEAR(line.amplitude, amplitude, 1e-14);
}

TEST(StrongestLines, AGaussianPeakIsReadExactly) {
  for (const double center : {2.3, 4.0, 6.7}) {
    Spectrum spectrum{.step = 0.5, .amplitude = {}};
    for (int k = 0; k < 10; ++k) spectrum.amplitude.push_back(3 * std::exp(-std::pow(k - center, 2) / 2));
    const auto line = strongest_line(spectrum);
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->angular_frequency, 0.5 * center, 1e-14);
    EXPECT_NEAR(line->amplitude, 3, 1e-13);
  }
}

TEST(StrongestLines, DriftIsPassedOverAndTheLastValueIsNoMaximum) {
  EXPECT_FALSE(strongest_line({1, {9, 8, 7, 7, 6, 5, 6}}));
  EXPECT_FALSE(strongest_line({1, {9, 8, 9}}));
  EXPECT_FALSE(strongest_line({1, {0, 8, 7}})) << "the first value belongs to the drift";
  const auto found = strongest_lines({1, {9, 8, 8, 2, 4, 2, 1, 3, 1}}, 0, 9);
  ASSERT_EQ(found.size(), 2u);
  expect_line(found[0], 4, 4);
  expect_line(found[1], 7, 3);
}

TEST(StrongestLines, AreThoseOfTheShareTheHighestFirst) {
  const Spectrum spectrum{1, {9, 1, 2, 1, 4, 1, 4, 1, 3, 1, 8, 1}};
  const auto places = [&](double share, std::size_t most) {
    std::vector<int> found;
    for (const auto& line : strongest_lines(spectrum, share, most))
      found.push_back(static_cast<int>(std::lround(line.angular_frequency)));
    return found;
  };
  EXPECT_EQ(places(0, 9), (std::vector{10, 4, 6, 8, 2}));
  EXPECT_EQ(places(0.5, 9), (std::vector{10, 4, 6}))
      << "just the share counts, and of equals the slower first";
  EXPECT_EQ(places(0.51, 9), std::vector{10});
  EXPECT_EQ(places(0, 2), (std::vector{10, 4}));
  EXPECT_TRUE(places(0, 0).empty());
}

TEST(StrongestLines, AreNotRefinedBesideZeroOrOnAFlatTop) {
  expect_line(*strongest_line({2, {5, 0, 2, 1, 0.5}}), 4, 2);
  expect_line(*strongest_line({2, {5, 1, 2, 0, 0}}), 4, 2);
  expect_line(*strongest_line({2, {5, 1, 2, 0, 1, 0}}), 4, 2);
  expect_line(strongest_lines({2, {5, 1, 2, 2, 2, 1}}, 0, 9).at(1), 6, 2);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
