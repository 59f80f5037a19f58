// What is left of a record when its law is taken off, and what it says about the law.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cromer/identify/least_squares/sampling.h"

namespace cromer::core {

// Residuals as an autoregression: each value is a sum over the values before it, plus white noise. Fitted by
// the Yule-Walker equations; the order is the one that Akaike's corrected criterion chooses, 0 for white
// noise (Burnham & Anderson, Model Selection, 2002, section 2.4).

/// r_i = sum over k of a_k r_(i-k) + white noise.
struct Autoregression {
  std::vector<double> coefficients;  ///< a_1, a_2, ...; none: white
  double innovation = 1;             ///< variance of that white noise over the variance of r

  /// Beyond such an order it is what a wrong law leaves that correlates.
  bool may_be_noise() const { return coefficients.size() <= 64; }

  /// Spectral density at an angle [rad per sample], over that of white noise of r's variance.
  double density(double angle) const;

  /// The variance of ln V, for a variance V whose logarithm has the derivatives slope[k - 1] by a_k: the
  /// sum of the innovation's part and the coefficients', whose covariance is the inverse of the Toeplitz
  /// matrix of autocovariances times innovation over samples. I. Gohberg & A. Semencul give that inverse as
  /// A Aᵀ - B Bᵀ, both triangular.
  double log_variance(std::span<const double> slope, double samples) const;
};

/// The autoregression of the best order up to `most` < rho.size(), from the autocorrelations `rho` of so
/// many samples.
Autoregression yule_walker(std::span<const double> rho, std::size_t samples, std::size_t most);

struct Residual {
  double rms = 0;                    ///< in the unit of the record
  double normality = 0;              ///< p of the Jarque-Bera test for the normal distribution
  double autocorrelation = 0;        ///< at lag 1; 0 where too few samples are neighbours
  double autocorrelation_error = 0;  ///< standard error of it, were the residuals white
  int strongest_lag = 1;  ///< where the autocorrelation is largest in size, less so where few pairs show it
  double strongest = 0;   ///< the autocorrelation there
  bool white = false;     ///< autocorrelations up to lag 20 are compatible with none (Ljung-Box, 1 %)
};

/// Jarque & Bera, Econ. Lett. 6, 255 (1980); Ljung & Box, Biometrika 65, 297 (1978), where samples are
/// missing with as many pairs as there are, and where the noise is uneven with as much more variance
/// (F. X. Diebold, Testing for serial correlation in the presence of ARCH, 1986). `r` is not empty; `rho` is
/// autocorrelations(r, grid, first_lags(r.size())).
Residual describe_residual(std::span<const double> r, const std::vector<double>& rho,
                           const SampleGrid& grid = {});

/// Residuals of this rms are what double arithmetic makes of a motion with the values `y`: no sensor sees a
/// billionth of its motion, and nothing is learnt from them.
bool is_arithmetic(double rms, std::span<const double> y);

/// Residuals of this rms are what rounding values to steps of `resolution` makes: 1/sqrt(12) of a step, and
/// up to a quarter more.
bool is_rounding(double rms, double resolution);

/// What a wrong law leaves dies down with the motion, unlike noise: its squares are more than so many times
/// as large in the first quarter as in the last. Of correlated noise they are so by chance more often.
bool dies_down(std::span<const double> r, double times);

/// Autocorrelations of `r` (about its mean) at lags 0 to `lags` < r.size(), the biased estimate: 1 at lag 0.
/// All 0 after it where r is constant.
std::vector<double> autocorrelations(std::span<const double> r, std::size_t lags);

/// The same of samples with gaps, from as many pairs as there are at each lag; all 0 where there are none.
std::vector<double> autocorrelations(std::span<const double> r, const SampleGrid& grid, std::size_t lags);

/// The residuals as an autoregression over the grid's steps, given their autocorrelations at the first lags;
/// more are found where its order asks for them.
Autoregression autoregression_of(std::span<const double> r, const std::vector<double>& rho,
                                 const SampleGrid& grid);

/// By what factor correlated residuals widen the variance of a parameter that lives at `phase_step` radians
/// per sample (0 for an equilibrium): the autoregression's spectral density there over that of white noise
/// of the same variance. Never below 1.
double correlation_factor(std::span<const double> r, double phase_step);

/// The same, given autocorrelations(r, first_lags(r.size())).
double correlation_factor(std::span<const double> r, const std::vector<double>& rho, double phase_step);

/// How many samples a stretch has in which the noise is taken to be alike: a fiftieth, at least 16.
std::size_t stretch_of(std::size_t samples);

/// The value that chi-squared exceeds as seldom as a normal variable exceeds `deviations` standard deviations
/// (Wilson & Hilferty, PNAS 17, 684 (1931)).
double chi_squared(double degrees, double deviations);

/// As many lags as white residuals need.
std::size_t first_lags(std::size_t samples);

}  // namespace cromer::core
