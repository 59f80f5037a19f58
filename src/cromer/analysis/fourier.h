// Fourier transforms. Their tables cost as much as a transform: each thread keeps them.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace cromer::core {

/// The smallest power of two that is at least 8 and not less than `least`. Values padded to it are fast to
/// transform.
std::size_t power_of_two(double least);

/// The sums of x_j exp(-2 pi i j k / n), k = 0 ... n / 2, of n real values.
void fourier_transform(const std::vector<double>& values, std::vector<std::complex<double>>& to);

/// The same for k = 0 ... n - 1, of n complex values.
void fourier_transform(const std::vector<std::complex<double>>& values,
                       std::vector<std::complex<double>>& to);

/// The n real values that have these n / 2 + 1 sums.
void inverse_fourier_transform(const std::vector<std::complex<double>>& sums, std::size_t n,
                               std::vector<double>& to);

}  // namespace cromer::core
