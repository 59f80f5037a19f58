#include "cromer/identify/modal/spectral_matrix.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>

#include "cromer/analysis/fourier.h"
#include "cromer/analysis/spectrum.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantile.h"

namespace cromer::core {
namespace {

std::size_t segment_length(const ModalRecord& record, std::size_t segments) {
  std::size_t longest = 0;
  for (std::size_t p = 0; p < record.starts.size(); ++p) {
    longest = std::max(longest, record.end(p) - record.starts[p]);
  }
  constexpr std::size_t shortest = 16;
  const std::size_t most = segments > 1 ? 4096 : 65536;
  std::size_t length = shortest;
  while (2 * length <= most && 2 * length * segments <= record.samples() && 2 * length <= longest)
    length *= 2;
  return length;
}

}  // namespace

SpectralMatrix spectral_matrix(const ModalRecord& record, std::size_t segments) {
  const std::size_t length = segment_length(record, segments), half = length / 2,
                    channels = record.channels.size();
  std::vector<double> window(length);
  double power = 0;
  for (std::size_t i = 0; i < length; ++i) {
    window[i] = 0.5 - 0.5 * std::cos(two_pi * (static_cast<double>(i) + 0.5) / static_cast<double>(length));
    power += window[i] * window[i];
  }
  std::vector<double> mean(channels);
  for (std::size_t c = 0; c < channels; ++c) {
    for (const double each : record.channels[c]) mean[c] += each;
    mean[c] /= static_cast<double>(record.samples());
  }
  const auto r = static_cast<Eigen::Index>(channels);
  std::vector<Eigen::MatrixXcd> spectra(half + 1, Eigen::MatrixXcd::Zero(r, r));
  std::vector<double> segment(length);
  std::vector<std::complex<double>> transformed;
  Eigen::MatrixXcd lines(r, static_cast<Eigen::Index>(half + 1));
  SpectralMatrix result;
  for (std::size_t p = 0; p < record.starts.size(); ++p) {
    const std::size_t end = record.end(p);
    for (std::size_t from = record.starts[p]; from + length <= end; from += half) {
      for (std::size_t c = 0; c < channels; ++c) {
        for (std::size_t i = 0; i < length; ++i)
          segment[i] = window[i] * (record.channels[c][from + i] - mean[c]);
        fourier_transform(segment, transformed);
        for (std::size_t k = 0; k <= half; ++k)
          lines(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(k)) = transformed[k];
      }
      for (std::size_t k = 0; k <= half; ++k) {
        const auto line = lines.col(static_cast<Eigen::Index>(k));
        spectra[k].noalias() += line * line.adjoint();
      }
      ++result.averages;
    }
  }
  result.step = 1 / (static_cast<double>(length) * record.step);
  const double scale = 2 * record.step / (power * std::max(1, result.averages));
  for (const Eigen::MatrixXcd& each : spectra) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(each, Eigen::EigenvaluesOnly);
    std::vector<double> values(channels);
    for (std::size_t c = 0; c < channels; ++c)
      values[c] = scale * std::max(0.0, solver.eigenvalues()(r - 1 - static_cast<Eigen::Index>(c)));
    result.singular.push_back(std::move(values));
  }
  return result;
}

std::vector<SpectralPeak> spectral_peaks(const SpectralMatrix& matrix) {
  const std::size_t n = matrix.singular.size(), reach = std::max<std::size_t>(8, n / 12);
  // Averages of squares scatter as chi-squared; half-overlapping ones as if they were fewer by a sixth.
  const double least = 1 + 8 / std::sqrt(std::max(1.0, matrix.averages * 5 / 6.0));
  std::vector<SpectralPeak> peaks;
  const auto first = [&](std::size_t k) { return matrix.singular[k].front(); };
  for (std::size_t k = 2; k + 1 < n; ++k) {
    if (!(first(k) > first(k - 1) && first(k) >= first(k + 1) && first(k + 1) > 0)) continue;
    std::vector<double> around;
    for (std::size_t i = k > reach ? k - reach : 1; i < std::min(n, k + reach + 1); ++i)
      around.push_back(first(i));
    const double prominence = first(k) / upper_median(around);
    if (!(prominence > least)) continue;
    const double offset = offset_of_maximum(first(k - 1), first(k), first(k + 1));
    peaks.push_back({(static_cast<double>(k) + offset) * matrix.step, prominence});
  }
  return peaks;
}

}  // namespace cromer::core
