#include "cromer/analysis/fourier.h"

#include <Eigen/Core>
#include <unsupported/Eigen/FFT>

namespace cromer::core {
namespace {

// Up to this length for good (2 MB each), of longer ones the last alone.
constexpr std::size_t longest_kept = 131072;

Eigen::FFT<double>& with_tables(std::size_t length) {
  thread_local Eigen::FFT<double> kept, longer;
  thread_local std::size_t length_of_longer = 0;
  const bool is_longer = length > longest_kept;
  if (is_longer && length != length_of_longer) longer = Eigen::FFT<double>(), length_of_longer = length;
  Eigen::FFT<double>& fft = is_longer ? longer : kept;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  return fft;
}

}  // namespace

std::size_t power_of_two(double least) {
  std::size_t n = 8;
  while (static_cast<double>(n) < least) n *= 2;
  return n;
}

void fourier_transform(const std::vector<double>& values, std::vector<std::complex<double>>& to) {
  with_tables(values.size()).fwd(to, values);
}

void fourier_transform(const std::vector<std::complex<double>>& values,
                       std::vector<std::complex<double>>& to) {
  with_tables(values.size()).fwd(to, values);
}

void inverse_fourier_transform(const std::vector<std::complex<double>>& sums, std::size_t n,
                               std::vector<double>& to) {
  with_tables(n).inv(to, sums, static_cast<Eigen::Index>(n));
}

}  // namespace cromer::core
