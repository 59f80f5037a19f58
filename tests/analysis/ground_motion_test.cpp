#include "cromer/analysis/ground_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <random>
#include <span>
#include <vector>

#include "cromer/base/pi.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double g = 9.80665;
constexpr auto hold = BetweenSamples::hold, linear = BetweenSamples::linear;

/// Of these samples, after which others lie that must not be read.
Intensity of(std::vector<double> a, double h, BetweenSamples between) {
  const std::size_t n = a.size();
  a.insert(a.end(), {1e3, 1e3});
  return intensity(std::span(a).first(n), h, between);
}

TEST(Intensity, OfAConstantIsByHand) {
  const Intensity held = of(std::vector(30, -2.0), 0.1, hold), joined = of(std::vector(31, 2.0), 0.1, linear);
  for (const Intensity& found : {held, joined}) {
    EXPECT_NEAR(found.arias, pi / (2 * g) * 4 * 3, 1e-14);
    EXPECT_NEAR(found.decades, std::log10(pi / (2 * g) * 4 * 3), 1e-14);
    EXPECT_NEAR(found.from, 0.05 * 3, 1e-14);
    EXPECT_NEAR(found.duration, 0.9 * 3, 1e-14);
  }
}

TEST(Intensity, OfARampIsByHand) {
  const double h = 0.5;
  const Intensity rising = of({0, 3}, h, linear), falling = of({3, 0}, h, linear),
                  through = of({-3, 3}, h, linear);
  EXPECT_NEAR(rising.arias, pi / (2 * g) * 3 * h, 1e-14);
  EXPECT_NEAR(rising.from, h * std::cbrt(0.05), 1e-14);
  EXPECT_NEAR(rising.duration, h * (std::cbrt(0.95) - std::cbrt(0.05)), 1e-14);
  EXPECT_NEAR(falling.arias, pi / (2 * g) * 3 * h, 1e-14);
  EXPECT_NEAR(falling.from, h * (1 - std::cbrt(0.95)), 1e-14);
  EXPECT_NEAR(through.arias, pi / (2 * g) * 3 * h, 1e-14);
  EXPECT_NEAR(through.from, h * (1 - std::cbrt(0.9)) / 2, 1e-14);
  EXPECT_NEAR(through.duration, h * std::cbrt(0.9), 1e-14);
}

// One cycle of a rectangle: up for two steps, down for two.
TEST(GroundPath, OfHeldSamplesIsByHand) {
  const std::vector<double> a{3, 3, -3, -3};
  const GroundPath path = ground_path(a, 0.5, hold);
  EXPECT_EQ(path.velocity, (std::vector<double>{0, 1.5, 3, 1.5}));
  EXPECT_EQ(path.displacement, (std::vector<double>{0, 0.375, 1.5, 2.625}));
  EXPECT_EQ(path.peak_velocity, 3);
  EXPECT_EQ(path.peak_displacement, 3);  // where the hold of the last sample ends
  EXPECT_EQ(cumulative_absolute_velocity(a, 0.5, hold), 6);
}

// a = 1 - t from 0 to 2, then -1 + (t - 2): v = t - t^2/2 peaks at 1/2, and is 0 at 2 where x is highest.
TEST(GroundPath, TurnsBetweenSamplesCount) {
  const std::vector<double> a{1, -1.0, 1};
  const GroundPath path = ground_path(a, 2, linear);
  EXPECT_NEAR(path.peak_velocity, 0.5, 1e-15);
  EXPECT_NEAR(path.peak_displacement, 2.0 / 3, 1e-15);
  EXPECT_NEAR(path.velocity[1], 0, 1e-15);
  EXPECT_NEAR(path.displacement[1], 2.0 / 3, 1e-15);
  EXPECT_NEAR(path.displacement[2], 0, 1e-15);
  EXPECT_NEAR(cumulative_absolute_velocity(a, 2, linear), 2, 1e-15);
  // v = t^2/2 - t, x = t^3/6 - t^2/2: from rest backwards, its turn inside the only interval.
  const GroundPath turned = ground_path(std::vector<double>{-1, 3}, 4, linear);
  EXPECT_NEAR(turned.peak_velocity, 4, 1e-14);
  EXPECT_NEAR(turned.peak_displacement, 8.0 / 3, 1e-14);
  const GroundPath there = ground_path(std::vector<double>{-1, 1.5}, 2.5, linear);
  EXPECT_NEAR(there.peak_displacement, 2.0 / 3, 1e-14);  // at 2, between the samples
}

// The displacement turns where the velocity is 0: at the root that a held or a falling acceleration has.
TEST(GroundPath, TurnsAtEitherRootOfItsVelocity) {
  for (const double sign : {1.0, -1.0}) {
    // Held: v = 1 - 2 t from 0.5 m on.
    const std::vector<double> held{sign, -2 * sign, sign};
    const GroundPath steps = ground_path(held, 1, BetweenSamples::hold);
    EXPECT_NEAR(steps.peak_displacement, 0.75, 1e-14);
    EXPECT_NEAR(steps.peak_velocity, 1, 1e-14);
    EXPECT_NEAR(steps.displacement[2], 0.5 * sign, 1e-14);
    EXPECT_NEAR(steps.velocity[2], -sign, 1e-14);
    // Joined: v = 2 t - 1.5 t^2, then 0.5 - t - t^2/2, 0 at sqrt(2) - 1.
    const std::vector<double> joined{2 * sign, -sign, -2 * sign};
    const GroundPath lines = ground_path(joined, 1, BetweenSamples::linear);
    const double t = std::sqrt(2.0) - 1;
    EXPECT_NEAR(lines.peak_displacement, 0.5 + t * (0.5 + t * (-0.5 - t / 6)), 1e-14);
    EXPECT_NEAR(lines.peak_velocity, 1, 1e-14) << "at the end";
    EXPECT_NEAR(lines.displacement[2], sign / 3, 1e-14);
    EXPECT_NEAR(lines.velocity[2], -sign, 1e-14);
    // Joined: v = 1 + t - 3 t^2 in the second interval, 0 at (1 + sqrt(13))/6.
    const std::vector<double> falling{sign, sign, -5 * sign};
    const double u = (1 + std::sqrt(13.0)) / 6;
    const GroundPath fall = ground_path(falling, 1, BetweenSamples::linear);
    EXPECT_NEAR(fall.peak_displacement, 0.5 + u * (1 + u * (0.5 - u)), 1e-14);
    EXPECT_NEAR(fall.peak_velocity, 1 + 1.0 / 12, 1e-14) << "1 + t - 3 t^2 at 1/6";
  }
}

TEST(GroundPath, IsThatOfAFineSum) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::vector<double> a(25);
  for (double& value : a) value = normal(random);
  const double h = 0.3;
  constexpr int fine = 4000;
  for (const auto between : {hold, linear}) {
    const GroundPath path = ground_path(a, h, between);
    const double step = h / fine;
    double v = 0, x = 0, most_v = 0, most_x = 0, sum = 0;
    for (std::size_t i = 0; i + (between == linear) < a.size(); ++i) {
      EXPECT_NEAR(path.velocity[i], v, 1e-9);
      EXPECT_NEAR(path.displacement[i], x, 1e-7);
      for (int k = 0; k < fine; ++k) {
        const double p = (k + 0.5) / fine;
        const double here = between == hold ? a[i] : a[i] + p * (a[i + 1] - a[i]);
        x += step * (v + step * here / 2);
        v += step * here;
        sum += step * std::abs(here);
        most_v = std::max(most_v, std::abs(v));
        most_x = std::max(most_x, std::abs(x));
      }
    }
    EXPECT_NEAR(path.peak_velocity, most_v, 1e-6);
    EXPECT_NEAR(path.peak_displacement, most_x, 1e-6);
    EXPECT_NEAR(cumulative_absolute_velocity(a, h, between), sum, 1e-6);
  }
}

TEST(BracketedDuration, IsFromTheFirstToTheLastReach) {
  const std::vector<double> a{0, 1, -2, 0, 0.5, 0};
  EXPECT_NEAR(bracketed_duration(a, 2, linear, 0.5), 2 * (4 - 0.5), 1e-15);
  EXPECT_NEAR(bracketed_duration(a, 2, linear, 1.0), 2 * (2.5 - 1), 1e-15);
  EXPECT_NEAR(bracketed_duration(a, 2, linear, 1.5), 2 * (2.25 - (1 + 2.5 / 3)), 1e-15);
  EXPECT_EQ(bracketed_duration(a, 2, linear, 2.5), 0);
  EXPECT_EQ(bracketed_duration(a, 2, hold, 1.0), 4);
  EXPECT_EQ(bracketed_duration(std::vector<double>{1, 1, 1}, 2, hold, 1.0), 6);
}

TEST(Intensity, OfAConstantReaches75PercentInTime) {
  EXPECT_NEAR(of(std::vector(31, 2.0), 0.1, linear).duration_75, 0.7 * 3, 1e-14);
}

TEST(Intensity, IsThatOfAFineSum) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<double> a(17);
  for (double& value : a) value = normal(random);
  const double h = 0.2;
  constexpr int fine = 20'000;
  for (const auto between : {hold, linear}) {
    std::vector<double> sums{0};
    for (std::size_t i = 0; i + (between == linear) < a.size(); ++i)
      for (int j = 0; j < fine; ++j) {
        const double part = (j + 0.5) / fine;
        const double value = between == hold ? a[i] : a[i] + part * (a[i + 1] - a[i]);
        sums.push_back(sums.back() + value * value * h / fine);
      }
    const auto time_of = [&](double share) {
      std::size_t i = 0;
      while (sums[i] < share * sums.back()) ++i;
      return static_cast<double>(i) * h / fine;
    };
    const Intensity found = of(a, h, between);
    EXPECT_NEAR(found.arias / (pi / (2 * g) * sums.back()), 1, 1e-8);
    EXPECT_NEAR(found.from, time_of(0.05), 1.5 * h / fine);
    EXPECT_NEAR(found.from + found.duration, time_of(0.95), 1.5 * h / fine);
  }
}

TEST(Intensity, AShareThatIsReachedAtASampleIsReachedThere) {
  // 20 equal samples: the first brings the 5 %, the last but one the 95 %.
  std::vector<double> a(26, 0.0);
  a[0] = 1;
  for (std::size_t i = 4; i < 22; ++i) a[i] = 1;
  a[25] = 1;
  const Intensity found = of(a, 0.5, hold);
  EXPECT_EQ(found.from, 0.5);
  EXPECT_EQ(found.from + found.duration, 11);
}

TEST(Intensity, HasItsDecadesWhereItIsBeyondAnyDouble) {
  for (const double size : {1e-320, 1e-200, 1e200, 1.5e308}) {
    const Intensity found = of(std::vector(30, size), 0.1, hold);
    EXPECT_TRUE(std::isnan(found.arias)) << size;
    EXPECT_NEAR(found.decades, std::log10(pi / (2 * g) * 3) + 2 * std::log10(size), 1e-12) << size;
    EXPECT_NEAR(found.duration, 2.7, 1e-13) << size;
  }
  EXPECT_NEAR(of(std::vector(30, 1e100), 0.1, hold).arias / (pi / (2 * g) * 3e200), 1, 1e-13);
  EXPECT_NEAR(of(std::vector(30, 1e-100), 0.1, hold).arias / (pi / (2 * g) * 3e-200), 1, 1e-13);
}

TEST(Intensity, IsNothingWhereNothingShakes) {
  for (const auto between : {hold, linear}) {
    const Intensity found = of({0, 0, 0}, 0.1, between);
    EXPECT_EQ(found.arias, 0);
    EXPECT_EQ(found.decades, 0);
    EXPECT_EQ(found.from, 0);
    EXPECT_EQ(found.duration, 0);
  }
}

TEST(FourierAmplitude, IsTheSumWrittenOut) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const double h = 0.02;
  for (const auto& [count, padded] :
       {std::pair<std::size_t, std::size_t>{2, 8}, {8, 8}, {9, 16}, {16, 16}, {17, 32}}) {
    std::vector<double> a(count);
    for (double& value : a) value = normal(random);
    const FourierAmplitude found = fourier_amplitude(a, h);
    const auto n = static_cast<double>(padded);
    EXPECT_NEAR(found.step * n * h, 1, 1e-14) << count;
    ASSERT_EQ(found.amplitude.size(), padded / 2 + 1) << count;
    for (std::size_t k = 0; k < found.amplitude.size(); ++k) {
      std::complex<double> sum = 0;
      for (std::size_t i = 0; i < count; ++i)
        sum += a[i] * std::polar(1.0, -2 * pi * static_cast<double>(i * k) / n);
      EXPECT_NEAR(found.amplitude[k], h * std::abs(sum), 1e-15) << count << ' ' << k;
    }
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
