// Fourier transforms. Their tables cost as much as a transform: those of common lengths are kept.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace cromer::core {

/// The power of two, from 8 on, that is not less: what is padded to it is fast to transform.
std::size_t power_of_two(double least);

/// The sums of x_j exp(-2 pi i j k / n), k = 0 ... n / 2, of n real values.
void fourier_transform(const std::vector<double>& values, std::vector<std::complex<double>>& to);

/// The same for k = 0 ... n - 1, of n complex values.
void fourier_transform(const std::vector<std::complex<double>>& values,
                       std::vector<std::complex<double>>& to);

/// The n real values whose transform this is, n / 2 + 1 sums.
void inverse_fourier_transform(const std::vector<std::complex<double>>& sums, std::size_t n,
                               std::vector<double>& to);

}  // namespace cromer::core
