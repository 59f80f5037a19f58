#include "cromer/analysis/ground_motion.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace cromer::core {
namespace {

/// Integral of a^2 over the part p, 0 to 1, of an interval of unit length.
double square_integral(double a0, double a1, double p) {
  const double rise = p * (a1 - a0);
  return p * (a0 * a0 + a0 * rise + rise * rise / 3);
}

/// The part of the interval at which that integral reaches `share`, which it does.
double part_reaching(double a0, double a1, double share) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (square_integral(a0, a1, middle) < share ? low : high) = middle;
  }
  return high;
}

}  // namespace

Intensity intensity(std::span<const double> a, double h, BetweenSamples between) {
  double peak = 0;
  for (const double value : a) peak = std::max(peak, std::abs(value));
  if (!(peak > 0)) return {};
  // In units of a power of two near the peak, so that squares neither overflow nor vanish.
  const int exponent = std::clamp(std::ilogb(peak), -1000, 1000);
  const double scale = std::ldexp(1.0, -exponent);
  const bool hold = between == BetweenSamples::hold;
  const std::size_t intervals = a.size() - (hold ? 0 : 1);
  const auto begin = [&](std::size_t i) { return scale * a[i]; };
  const auto end = [&](std::size_t i) { return scale * (hold ? a[i] : a[i + 1]); };
  double all = 0;
  for (std::size_t i = 0; i < intervals; ++i) all += square_integral(begin(i), end(i), 1);
  if (!(all > 0)) return {};
  const auto time_of = [&](double share) {
    double sum = 0;
    for (std::size_t i = 0; i < intervals; ++i) {
      const double next = sum + square_integral(begin(i), end(i), 1);
      if (next >= share * all)
        return h * (static_cast<double>(i) + part_reaching(begin(i), end(i), share * all - sum));
      sum = next;
    }
    return h * static_cast<double>(intervals);
  };
  const double scaled = std::numbers::pi / (2 * standard_gravity) * h * all;
  const double arias = std::ldexp(scaled, 2 * exponent);
  const double from = time_of(0.05);
  return {std::isnormal(arias) ? arias : std::numeric_limits<double>::quiet_NaN(),
          std::log10(scaled) + 2 * exponent * std::log10(2.0), from, time_of(0.95) - from};
}

FourierAmplitude fourier_amplitude(std::span<const double> a, double h) {
  std::size_t padded = 8;
  while (padded < a.size()) padded *= 2;
  std::vector<double> samples(padded, 0.0);
  std::copy(a.begin(), a.end(), samples.begin());
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> transform;
  fft.fwd(transform, samples);
  FourierAmplitude result{1 / (static_cast<double>(padded) * h), {}};
  result.amplitude.reserve(transform.size());
  for (const auto& value : transform) result.amplitude.push_back(h * std::abs(value));
  return result;
}

}  // namespace cromer::core
