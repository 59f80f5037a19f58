#include "cromer/analysis/hysteretic_peaks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>
#include <utility>
#include <vector>

#include "cromer/analysis/frequency_response.h"
#include "cromer/base/pi.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(HystereticResponse, IsThatOfAComplexSpring) {
  using namespace std::complex_literals;
  const Oscillator<double> o{.mass = 2, .stiffness = 50, .damping = 0};
  for (const double w : {0.1, 4.9, 5.0, 5.1, 30.0}) {
    const std::complex<double> truth = 3.0 / (50.0 * (1.0 + 0.2i) - 2 * w * w);
    const SteadyState found = hysteretic_response(o, 0.2, 3, w);
    EXPECT_NEAR(found.amplitude / std::abs(truth), 1, 1e-14);
    EXPECT_NEAR(found.phase_lag, -std::arg(truth), 1e-14);
  }
  // At resonance a damper of half the ratio does the same; the force on it does not grow with frequency.
  const Oscillator<double> viscous{.mass = 2, .stiffness = 50, .damping = 2 * 0.1 * std::sqrt(2.0 * 50)};
  EXPECT_NEAR(hysteretic_response(o, 0.2, 3, 5).amplitude, frequency_response(viscous, 3, 5).amplitude,
              1e-14);
  EXPECT_NEAR(hysteretic_response(o, 0.2, 3, 1e-9).phase_lag, std::atan(0.2), 1e-12);
}

/// Whole cycles of a sinusoid under an envelope that is long beside the memory of the oscillator.
std::vector<double> burst(double w, double h, std::size_t n) {
  std::vector<double> a(n);
  for (std::size_t i = 0; i < n; ++i)
    a[i] = std::pow(std::sin(pi * static_cast<double>(i) / static_cast<double>(n)), 2) *
           std::cos(w * h * static_cast<double>(i));
  return a;
}

TEST(HystereticPeaks, OfALongBurstAreItsSteadyState) {
  const double h = 0.01;
  for (const double driven : {2.0, 5.0, 12.0}) {
    const auto a = burst(driven, h, 40000);
    const double period = 2 * pi / 5, loss_factor = 0.2;
    const double steady = hysteretic_response({.mass = 1, .stiffness = 25}, loss_factor, 1, driven).amplitude;
    EXPECT_NEAR(hysteretic_peaks(a, h, std::vector{period}, loss_factor)[0] / steady, 1, 2e-3) << driven;
  }
}

TEST(HystereticPeaks, OfLittleDampingAreThoseOfADamper) {
  // A short pulse sets it swinging: the first swing hardly knows what will damp it.
  const double h = 0.01, period = 1.0, w = 2 * pi / period;
  std::vector<double> a(400, 0.0);
  for (std::size_t i = 0; i <= 5; ++i) a[i] = std::sin(pi * static_cast<double>(i) / 5);
  double impulse = 0;
  for (const double value : a) impulse += h * value;
  const double undamped = impulse / w * std::cos(w * 2.5 * h / 2);
  EXPECT_NEAR(hysteretic_peaks(a, h, std::vector{period}, 0.02)[0] / undamped, 1 - 0.02 * pi / 4, 0.01);
}

// Sum and reading against the sum itself, term by term, at 64 times in every sample: fast oscillators, which
// are read often, and slow ones, which follow what is faster than themselves a little too.
TEST(HystereticPeaks, AreTheSumOfSteadyStates) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::vector<double> a(200);
  for (double& value : a) value = normal(random);
  const double h = 0.02;
  const std::size_t padded = 1024, times = 64;
  // 200 samples, and the pause: 512 to 1024 in all.
  const std::pair<double, double> all[] = {{0.12, 0.3}, {0.18, 0.3}, {0.22, 0.3}, {0.45, 0.3},
                                           {0.6, 0.3},  {1.18, 0.9}, {1.22, 0.9}, {1.6, 0.9}};
  std::vector<std::complex<double>> ground(padded / 2 + 1);
  for (std::size_t k = 0; k < ground.size(); ++k)
    for (std::size_t i = 0; i < a.size(); ++i)
      ground[k] += a[i] * std::polar(1.0, -2 * pi * static_cast<double>(k * i % padded) / padded);
  std::vector<std::complex<double>> turn(times * padded);
  for (std::size_t i = 0; i < turn.size(); ++i)
    turn[i] = std::polar(1.0, 2 * pi * static_cast<double>(i) / static_cast<double>(turn.size()));
  for (const auto& [period, loss_factor] : all) {
    const double w = 2 * pi / period;
    const double samples = hysteretic_samples(a.size(), h, period, loss_factor);
    ASSERT_GT(samples, padded / 2) << period;
    ASSERT_LE(samples, padded) << period;
    std::vector<std::complex<double>> amplitude;
    for (std::size_t k = 0; k <= padded / 2; ++k) {
      const double driven = 2 * pi * static_cast<double>(k) / (padded * h);
      const auto steady = hysteretic_response({.mass = 1, .stiffness = w * w}, loss_factor, 1, driven);
      amplitude.push_back(ground[k] * std::polar(steady.amplitude, -steady.phase_lag));
    }
    double most = 0;
    for (std::size_t i = 0; i < times * padded; ++i) {
      double x = amplitude[0].real();
      for (std::size_t k = 1; k < amplitude.size(); ++k)
        x += (2 * k == padded ? 1 : 2) * (amplitude[k] * turn[k * i % turn.size()]).real();
      most = std::max(most, std::abs(x) / padded);
    }
    EXPECT_NEAR(hysteretic_peaks(a, h, std::vector{period}, loss_factor)[0] / most, 1, 1e-4) << period;
  }
}

// What the pauses leave out is what silence after the record adds.
TEST(HystereticPeaks, AreThoseOfASingleShaking) {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  const double h = 0.01;
  std::vector<double> a(500);
  for (double& value : a) value = normal(random);
  std::vector<double> silent = a;
  silent.resize(1 << 15);
  const std::vector<double> periods{0.1, 0.2, 0.5, 1.25};
  for (const double loss_factor : {0.04, 0.4, 1.0, 2.0}) {
    const auto peaks = hysteretic_peaks(a, h, periods, loss_factor),
               truth = hysteretic_peaks(silent, h, periods, loss_factor);
    for (std::size_t i = 0; i < periods.size(); ++i)
      EXPECT_NEAR(peaks[i] / truth[i], 1, 1e-3) << loss_factor << ' ' << periods[i];
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
