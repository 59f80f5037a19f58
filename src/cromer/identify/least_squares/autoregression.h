// Noise as an autoregression: each value a sum over the values before it, plus white noise.
//
// Fitted by the Yule-Walker equations, of the order that Akaike's corrected criterion chooses (Burnham &
// Anderson, Model Selection, 2002, section 2.4): none for white noise.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace cromer::core {

/// r_i = sum over k of a_k r_(i-k) + white noise.
struct Autoregression {
  std::vector<double> coefficients;  ///< a_1, a_2, ...; none: white
  double innovation = 1;             ///< variance of that white noise over the variance of r

  /// Spectral density at an angle [rad per sample], over that of white noise of r's variance.
  double density(double angle) const;

  /// The variance of the logarithm of a variance that grows by slope[k - 1] (of its logarithm) with a_k:
  /// that of the innovation and that of the coefficients, whose covariance is the inverse of the Toeplitz
  /// matrix of autocovariances times innovation over samples. I. Gohberg & A. Semencul give that inverse as
  /// A Aᵀ - B Bᵀ, triangular both.
  double log_variance(std::span<const double> slope, double samples) const;
};

/// The best order up to `most` < rho.size(), from the autocorrelations of so many samples.
Autoregression yule_walker(std::span<const double> rho, std::size_t samples, std::size_t most);

}  // namespace cromer::core
