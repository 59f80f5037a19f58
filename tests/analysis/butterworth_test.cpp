#include "cromer/analysis/butterworth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "cromer/analysis/baseline.h"
#include "cromer/base/pi.h"

namespace cromer::core {
namespace CROMER_FILE {

/// |H|² of the definition, at f.
double gain_squared(int order, const PassBand& band, double h, double f) {
  const double w = std::tan(pi * f * h), low = std::tan(pi * band.low * h),
               high = band.has_high() ? std::tan(pi * band.high * h) : 0;
  const double ratio = !band.has_low()    ? w / high
                       : !band.has_high() ? low / w
                                          : (w * w - low * high) / ((high - low) * w);
  return 1 / (1 + std::pow(ratio * ratio, order));
}

/// The response to e^{2 pi i f t}, from the sections' own transfer functions.
std::complex<double> response(const std::vector<FilterSection>& sections, double f, double h) {
  const std::complex<double> back = std::polar(1.0, -2 * pi * f * h);
  std::complex<double> all = 1;
  for (const FilterSection& s : sections)
    all *= (s.b0 + back * (s.b1 + back * s.b2)) / (1.0 + back * (s.a1 + back * s.a2));
  return all;
}

const PassBand bands[] = {
    {.low = 0.1, .high = 25}, {.low = 3, .high = 4}, {.low = 2}, {.high = 10}, {.low = 0.05, .high = 49}};

TEST(Butterworth, OfFirstOrderIsItsClosedFormUpToTheEndsOfTheBand) {
  // s = -W by s = (z - 1)/(z + 1): a pole at (1 - W)/(1 + W).
  for (const double f : {1e-7, 1e-4, 0.1, 0.25, 0.4, 0.49999, 0.4999999}) {
    const double w = std::tan(pi * f), pole = (1 - w) / (1 + w);
    const auto slow = butterworth(1, {.high = f}, 1), fast = butterworth(1, {.low = f}, 1);
    for (const auto* sections : {&slow, &fast}) {
      ASSERT_EQ(sections->size(), 1u) << f;
      EXPECT_NEAR(sections->front().a1, -pole, 1e-15) << f;
      EXPECT_EQ(sections->front().a2, 0) << f;
      EXPECT_EQ(sections->front().b2, 0) << f;
    }
    EXPECT_NEAR(slow[0].b0 * (1 + w) / w, 1, 1e-8) << f;
    EXPECT_NEAR(slow[0].b1 * (1 + w) / w, 1, 1e-8) << f;
    EXPECT_NEAR(fast[0].b0 * (1 + w), 1, 1e-8) << f;
    EXPECT_NEAR(fast[0].b1 * (1 + w), -1, 1e-8) << f;
    for (int order = 2; order <= 8; ++order)
      for (const PassBand& band : {PassBand{.high = f}, PassBand{.low = f}}) {
        const auto sections = butterworth(order, band, 1);
        ASSERT_EQ(sections.size(), static_cast<std::size_t>((order + 1) / 2)) << f << ' ' << order;
        EXPECT_EQ(sections.back().a2 == 0, order % 2 == 1) << f << ' ' << order;
      }
  }
}

TEST(Butterworth, HasTheGainOfItsDefinition) {
  const double h = 0.01;
  for (const PassBand& band : bands)
    for (int order = 1; order <= 8; ++order) {
      const auto sections = butterworth(order, band, h);
      for (double f = 0.03; f < 50; f *= 1.3) {
        const double truth = gain_squared(order, band, h, f);
        if (truth < 1e-12) continue;
        EXPECT_NEAR(std::norm(response(sections, f, h)) / truth, 1, 1e-6)
            << order << " " << band.low << " " << f;
      }
    }
}

// In the steady state after a long time a sinusoid keeps its frequency, times the gain: forwards once, and
// forwards and backwards without any phase.
TEST(Butterworth, FiltersASinusoid) {
  const double h = 0.005, f = 0.7;
  const PassBand band{.low = 0.5, .high = 20};
  for (const int order : {2, 3, 4}) {
    const auto sections = butterworth(order, band, h);
    constexpr std::size_t n = 40001;
    std::vector<double> once(n), twice;
    for (std::size_t i = 0; i < n; ++i) once[i] = std::sin(2 * pi * f * h * static_cast<double>(i));
    twice = once;
    const std::vector<double> given = once;
    filter(sections, once);
    filter_both_ways(sections, twice);
    const double gain = std::sqrt(gain_squared(order, band, h, f));
    const std::size_t middle = n / 2;
    double most = 0;
    for (std::size_t i = middle; i < middle + 1000; ++i) {
      most = std::max(most, std::abs(once[i]));
      EXPECT_NEAR(twice[i], gain * gain * given[i], 1e-9);
    }
    EXPECT_NEAR(most, gain, 2e-4);  // the samples miss the crest a little
  }
}

// A section whose own gain is far above 1 leaves little of the digits for the next one to take it off.
TEST(Butterworth, WideBandsOfHighOrderKeepTheirDigits) {
  const double h = 0.005;
  const PassBand band{.low = 0.05, .high = 50};
  for (const int order : {4, 7, 12}) {
    std::vector<double> answer(1 << 17);
    answer[0] = 1;
    filter(butterworth(order, band, h), answer);
    for (const double f : {0.04, 0.06, 0.5, 5.0, 45.0, 55.0}) {
      std::complex<double> sum = 0;
      for (std::size_t i = answer.size(); i-- > 0;) sum = answer[i] + std::polar(1.0, -2 * pi * f * h) * sum;
      EXPECT_NEAR(std::norm(sum), gain_squared(order, band, h, f), 1e-8) << order << " " << f;
    }
  }
}

TEST(Butterworth, ForgetsWithinItsMemory) {
  const double h = 0.01;
  for (const PassBand& band : bands)
    for (const int order : {1, 2, 4, 5}) {
      const auto sections = butterworth(order, band, h);
      const double memory = memory_of(sections, h);
      const auto length = static_cast<std::size_t>(std::ceil(memory / h));
      std::vector<double> pulse(3 * length + 1);
      pulse[0] = 1;
      filter(sections, pulse);
      double most = 0, late = 0;
      for (std::size_t i = 0; i < pulse.size(); ++i)
        (i < length ? most : late) = std::max(i < length ? most : late, std::abs(pulse[i]));
      EXPECT_LT(late, 1e-4 * most) << order << " " << band.low;
    }
}

TEST(Polynomial, IsTheOneOfLeastSquares) {
  std::vector<double> y;
  for (int i = 0; i < 50; ++i) {
    const double t = i * 0.1;
    y.push_back(1 - 2 * t + 0.3 * t * t - 0.05 * t * t * t);
  }
  const auto cubic = least_squares_polynomial(y, 3);
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(cubic[i], y[i], 1e-12);
  // What a lower one leaves is orthogonal to all powers up to its degree.
  for (int degree = 0; degree < 3; ++degree) {
    const auto line = least_squares_polynomial(y, degree);
    for (int power = 0; power <= degree; ++power) {
      double sum = 0;
      for (std::size_t i = 0; i < y.size(); ++i)
        sum += (y[i] - line[i]) * std::pow(0.1 * static_cast<double>(i), power);
      EXPECT_NEAR(sum, 0, 1e-9) << degree << " " << power;
    }
    if (degree == 0) {
      EXPECT_NEAR(line.front(), line.back(), 1e-15);
    }
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
