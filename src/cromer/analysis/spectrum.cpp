#include "cromer/analysis/spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "cromer/analysis/fourier.h"
#include "cromer/base/pi.h"

namespace cromer::core {

Spectrum amplitude_spectrum(std::span<const double> y, double h) {
  const std::size_t n = y.size();
  const std::size_t padded = power_of_two(static_cast<double>(n));
  double mean = 0;
  for (double value : y) mean += value;
  mean /= static_cast<double>(n);

  // Hann window by the recurrence of cosines; exact enough for a weight.
  std::vector<double> windowed(padded, 0.0);
  const double angle = two_pi / static_cast<double>(n);
  const std::complex<double> turn = std::polar(1.0, angle);
  std::complex<double> phase = std::polar(1.0, angle / 2);
  for (std::size_t i = 0; i < n; ++i) {
    windowed[i] = (y[i] - mean) * (0.5 - 0.5 * phase.real());
    phase = {phase.real() * turn.real() - phase.imag() * turn.imag(),
             phase.real() * turn.imag() + phase.imag() * turn.real()};
  }

  std::vector<std::complex<double>> transformed;
  fourier_transform(windowed, transformed);

  Spectrum spectrum;
  spectrum.step = two_pi / (static_cast<double>(padded) * h);
  spectrum.amplitude.resize(transformed.size());
  const double scale = 4 / static_cast<double>(n);  // two sides, and the window's mean of one half
  for (std::size_t k = 0; k < transformed.size(); ++k)
    spectrum.amplitude[k] = scale * std::sqrt(transformed[k].real() * transformed[k].real() +
                                              transformed[k].imag() * transformed[k].imag());
  return spectrum;
}

Spectrum least_squares_spectrum(std::span<const double> t, std::span<const double> y, double h) {
  const double duration = t.back() - t.front();
  const std::size_t padded = power_of_two(3 * duration / h + 2);  // two parts far apart beat

  // Weights in the imaginary part, weighted values in the real one: one transform serves both.
  const auto weight_at = [&](double time) {
    return 1.0001 - std::cos(two_pi * (time - t.front()) / duration);
  };
  double sum = 0, mean = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    sum += weight_at(t[i]);
    mean += weight_at(t[i]) * y[i];
  }
  mean /= sum;
  std::vector<std::complex<double>> grid(padded), z;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double weight = weight_at(t[i]) / sum, place = (t[i] - t.front()) / h;
    const auto k = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(k);
    const std::complex<double> both(weight * (y[i] - mean), weight);
    grid[k] += (1 - share) * both;
    grid[k + 1] += share * both;
  }
  fourier_transform(grid, z);
  const auto of_values = [&](std::size_t k) { return 0.5 * (z[k] + std::conj(z[(padded - k) % padded])); };
  const auto of_weights = [&](std::size_t k) {
    const std::complex<double> twice = z[k] - std::conj(z[(padded - k) % padded]);
    return std::complex<double>(0.5 * twice.imag(), -0.5 * twice.real());
  };

  Spectrum spectrum;
  spectrum.step = two_pi / (static_cast<double>(padded) * h);
  spectrum.amplitude.resize(padded / 2 + 1);
  for (std::size_t k = 1; k < spectrum.amplitude.size(); ++k) {
    // Sums of the weighted products of cosine, sine and value, each about its mean.
    const std::complex<double> value = of_values(k), one = of_weights(k), two = of_weights(2 * k % padded);
    const double yc = value.real(), ys = -value.imag(), c = one.real(), s = -one.imag();
    const double cc = 0.5 * (1 + two.real()) - c * c, ss = 0.5 * (1 - two.real()) - s * s;
    const double cs = -0.5 * two.imag() - c * s, determinant = cc * ss - cs * cs;
    if (!(determinant > 1e-9)) continue;  // slower than the record shows, or the highest frequency
    const double explained = (ss * yc * yc + cc * ys * ys - 2 * cs * yc * ys) / determinant;
    spectrum.amplitude[k] = std::sqrt(2 * std::max(0.0, explained));
  }
  return spectrum;
}

namespace {

// The local maximum at place k, refined.
SpectralLine line_at(const Spectrum& spectrum, std::size_t k) {
  const auto& a = spectrum.amplitude;
  const double offset = offset_of_maximum(a[k - 1], a[k], a[k + 1]);
  SpectralLine line{static_cast<double>(k) * spectrum.step + offset * spectrum.step, a[k]};
  if (offset != 0) line.amplitude *= std::exp(-0.25 * offset * std::log(a[k - 1] / a[k + 1]));
  return line;
}

}  // namespace

std::vector<SpectralLine> strongest_lines(const Spectrum& spectrum, double share, std::size_t most) {
  const auto& a = spectrum.amplitude;
  std::size_t k = 1;
  while (k + 1 < a.size() && a[k + 1] <= a[k]) ++k;  // down the slope of the drift
  std::vector<std::size_t> maxima;
  for (; k + 1 < a.size(); ++k)
    if (a[k] > 0 && a[k] >= a[k - 1] && a[k] >= a[k + 1]) maxima.push_back(k);
  most = std::min(most, maxima.size());
  std::partial_sort(maxima.begin(), maxima.begin() + static_cast<std::ptrdiff_t>(most), maxima.end(),
                    [&](std::size_t i, std::size_t j) { return a[i] > a[j] || (a[i] == a[j] && i < j); });
  std::vector<SpectralLine> lines;
  for (std::size_t i = 0; i < most && a[maxima[i]] >= share * a[maxima[0]]; ++i)
    lines.push_back(line_at(spectrum, maxima[i]));
  return lines;
}

double offset_of_maximum(double before, double at, double after) {
  if (!(before > 0 && at > 0 && after > 0)) return 0;
  const double left = std::log(before / at), right = std::log(after / at);
  return left + right < 0 ? 0.5 * (left - right) / (left + right) : 0;
}

std::optional<SpectralLine> strongest_line(const Spectrum& spectrum) {
  const std::vector<SpectralLine> lines = strongest_lines(spectrum, 1, 1);
  if (lines.empty()) return std::nullopt;
  return lines.front();
}

}  // namespace cromer::core
