#include "cromer/analysis/fourier.h"

#include <Eigen/Core>
#include <unsupported/Eigen/FFT>

namespace cromer::core {
namespace {

template <class Use>
void with_tables(std::size_t length, Use use) {
  constexpr std::size_t longest_kept = 131072;
  thread_local Eigen::FFT<double> kept;
  Eigen::FFT<double> own;
  Eigen::FFT<double>& fft = length <= longest_kept ? kept : own;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  use(fft);
}

}  // namespace

std::size_t power_of_two(double least) {
  std::size_t n = 8;
  while (static_cast<double>(n) < least) n *= 2;
  return n;
}

void fourier_transform(const std::vector<double>& values, std::vector<std::complex<double>>& to) {
  with_tables(values.size(), [&](auto& fft) { fft.fwd(to, values); });
}

void fourier_transform(const std::vector<std::complex<double>>& values,
                       std::vector<std::complex<double>>& to) {
  with_tables(values.size(), [&](auto& fft) { fft.fwd(to, values); });
}

void inverse_fourier_transform(const std::vector<std::complex<double>>& sums, std::size_t n,
                               std::vector<double>& to) {
  with_tables(n, [&](auto& fft) { fft.inv(to, sums, static_cast<Eigen::Index>(n)); });
}

}  // namespace cromer::core
