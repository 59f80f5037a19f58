// What is left of a record when its law is taken off, and what it says about the law.
#pragma once

#include <span>
#include <vector>

#include "cromer/identify/least_squares/autoregression.h"
#include "cromer/identify/least_squares/sample_grid.h"

namespace cromer::core {

struct Residual {
  double rms = 0;              ///< in the unit of the record
  double normality = 0;        ///< p of the Jarque-Bera test for the normal distribution
  double autocorrelation = 0;  ///< at lag 1
  int strongest_lag = 1;       ///< where the autocorrelation is largest in size, of those looked at
  double strongest = 0;        ///< the autocorrelation there
  bool white = false;          ///< autocorrelations up to lag 20 are compatible with none (Ljung-Box, 1 %)
};

/// Jarque & Bera, Econ. Lett. 6, 255 (1980); Ljung & Box, Biometrika 65, 297 (1978). `r` is not empty; `rho`
/// is autocorrelations(r, first_lags(r.size())).
Residual describe_residual(std::span<const double> r, const std::vector<double>& rho);

/// Residuals of this rms are what double arithmetic makes of a motion with the values `y`: no sensor sees a
/// billionth of its motion, and nothing is learnt from them.
bool is_arithmetic(double rms, std::span<const double> y);

/// Autocorrelations of `r` (about its mean) at lags 0 to `lags` < r.size(), the biased estimate: 1 at lag 0.
/// All 0 after it where r is constant.
std::vector<double> autocorrelations(std::span<const double> r, std::size_t lags);

/// The same of samples with gaps, from as many pairs as there are at each lag; all 0 where there are none.
std::vector<double> autocorrelations(std::span<const double> r, const SampleGrid& grid, std::size_t lags);

/// The residuals as an autoregression over the grid's steps, given their autocorrelations at the first lags;
/// more are found where its order asks for them.
Autoregression autoregression_of(std::span<const double> r, const std::vector<double>& rho,
                                 const SampleGrid& grid);

/// By what factor residuals that are correlated widen the variance of a parameter which lives at `phase_step`
/// radians per sample (0 for an equilibrium): their spectral density there over that of white noise of the
/// same variance, that of an autoregression. Never below 1.
double correlation_factor(std::span<const double> r, double phase_step);

/// The same, given autocorrelations(r, first_lags(r.size())).
double correlation_factor(std::span<const double> r, const std::vector<double>& rho, double phase_step);

/// As many lags as white residuals need.
std::size_t first_lags(std::size_t samples);

}  // namespace cromer::core
