// How the peaks of a response spectrum are read off: of motions that repeat within the recording, whose
// values are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

#include "cromer/analysis/hysteretic_peaks.h"
#include "cromer/base/pi.h"

namespace cromer::core {
namespace CROMER_FILE {

struct Tone {
  int cycles;  // in 64 samples
  double amplitude;
};

/// Sines that all vanish at the last of 64 samples, which is left to the pause.
std::vector<double> recording(const std::vector<Tone>& tones) {
  std::vector<double> a(63, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (const auto& [cycles, amplitude] : tones)
      a[i] += amplitude * std::sin(2 * pi * cycles * static_cast<double>(i + 1) / 64);
  return a;
}

/// The largest magnitude of the quartics (Lagrange's) through five of the values that a sample is divided
/// into, each about one that is larger than its neighbours, by looking at many places.
double reading(const std::vector<Tone>& tones, double period, double loss_factor, int divisions) {
  const double w = 2 * pi / period;
  const int n = 64 * divisions;
  std::vector<double> x(static_cast<std::size_t>(n), 0.0);
  for (const auto& [cycles, amplitude] : tones) {
    const double driven = 2 * pi * cycles / 64;
    const auto answer = amplitude / std::complex<double>(w * w - driven * driven, loss_factor * w * w);
    for (int i = 0; i < n; ++i)
      x[static_cast<std::size_t>(i)] +=
          (answer * std::polar(1.0, driven * (static_cast<double>(i) / divisions + 1))).imag();
  }
  const auto value = [&](int i) { return x[static_cast<std::size_t>((i + n) % n)]; };
  double most = 0;
  for (int i = 0; i < n; ++i) {
    if (std::abs(value(i)) < std::max(std::abs(value(i - 1)), std::abs(value(i + 1)))) continue;
    for (int j = -600; j <= 600; ++j) {
      double sum = 0;
      for (int k = -2; k <= 2; ++k) {
        double weight = 1;
        for (int m = -2; m <= 2; ++m)
          if (m != k) weight *= (j / 1000.0 - m) / (k - m);
        sum += weight * value(i + k);
      }
      most = std::max(most, std::abs(sum));
    }
  }
  return most;
}

TEST(HystereticReading, IsTheTopOfTheQuarticThroughFiveValues) {
  // Half as many values in a sample for slower oscillators; so large a loss factor needs less than a sample's
  // pause.
  for (const auto& [period, divisions] : {std::pair{9.9, 8}, {10.1, 4}, {59.0, 4}, {61.0, 2}})
    for (const double more : {1.01, 1.4, 2.0, 3.0})
      for (const auto& tones : {std::vector<Tone>{{16, 1}},
                                {{13, 1}},
                                {{1, 1}},
                                {{16, -1}, {8, 0.3}},
                                {{20, 1}, {5, -0.4}, {3, 0.2}}}) {
        const double loss_factor = 600 * more;
        const auto found = hysteretic_peaks(recording(tones), 1, std::vector{period}, loss_factor);
        EXPECT_NEAR(found[0] / reading(tones, period, loss_factor, divisions), 1, 3e-7)
            << period << ' ' << more << ' ' << tones[0].cycles;
      }
}

TEST(HystereticReading, ThePauseIsThatOfAFallToATenThousandth) {
  // A free motion falls by exp(-pi eta) in a period.
  const double pause = hysteretic_samples(300, 0.02, 1.5, 0.07) - 300;
  EXPECT_NEAR(std::exp(-pi * 0.07 * pause * 0.02 / 1.5), 1e-4, 1e-17);
}

TEST(HystereticReading, ARecordingThatFillsItsLengthIsNotPadded) {
  // 8 samples of a cosine, 4 in a cycle; a pause of less than the rounding of 8.
  const std::vector<double> a{1, 0, -1, 0, 1, 0, -1, 0};
  const double period = 5, eta = 1e17, w = 2 * pi / period;
  EXPECT_NEAR(hysteretic_peaks(a, 1, std::vector{period}, eta)[0] * (eta * w * w), 1, 1e-12);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
