#include "cromer/analysis/spectrum.h"

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace cromer {

Spectrum amplitude_spectrum(std::span<const double> y, double h) {
  const std::size_t n = y.size();
  std::size_t padded = 8;
  while (padded < n) padded *= 2;
  double mean = 0;
  for (double value : y) mean += value;
  mean /= static_cast<double>(n);

  // Hann window by the recurrence of cosines; exact enough for a weight.
  std::vector<double> windowed(padded, 0.0);
  const double angle = 2 * std::numbers::pi / static_cast<double>(n);
  const std::complex<double> turn = std::polar(1.0, angle);
  std::complex<double> phase = std::polar(1.0, angle / 2);
  for (std::size_t i = 0; i < n; ++i) {
    windowed[i] = (y[i] - mean) * (0.5 - 0.5 * phase.real());
    phase = {phase.real() * turn.real() - phase.imag() * turn.imag(),
             phase.real() * turn.imag() + phase.imag() * turn.real()};
  }

  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> transform;
  fft.fwd(transform, windowed);

  Spectrum spectrum;
  spectrum.step = 2 * std::numbers::pi / (static_cast<double>(padded) * h);
  spectrum.amplitude.resize(transform.size());
  const double scale = 4 / static_cast<double>(n);  // two sides, and the window's mean of one half
  for (std::size_t k = 0; k < transform.size(); ++k)
    spectrum.amplitude[k] = scale * std::sqrt(transform[k].real() * transform[k].real() +
                                              transform[k].imag() * transform[k].imag());
  return spectrum;
}

std::optional<SpectralLine> strongest_line(const Spectrum& spectrum) {
  const auto& a = spectrum.amplitude;
  std::size_t k = 1;
  while (k + 1 < a.size() && a[k + 1] <= a[k]) ++k;  // down the slope of the drift
  std::size_t best = 0;
  for (; k + 1 < a.size(); ++k)
    if (a[k] >= a[k - 1] && a[k] >= a[k + 1] && (best == 0 || a[k] > a[best])) best = k;
  if (best == 0 || !(a[best] > 0)) return std::nullopt;
  SpectralLine line{static_cast<double>(best) * spectrum.step, a[best]};
  if (a[best - 1] > 0 && a[best + 1] > 0) {
    const double left = std::log(a[best - 1] / a[best]), right = std::log(a[best + 1] / a[best]);
    const double curvature = left + right;
    if (curvature < 0) {
      const double offset = 0.5 * (left - right) / curvature;
      line.angular_frequency += offset * spectrum.step;
      line.amplitude *= std::exp(-0.125 * (left - right) * (left - right) / curvature);
    }
  }
  return line;
}

}  // namespace cromer
