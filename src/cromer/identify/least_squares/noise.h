// The noise of a record as its residuals show it, and what it does to the estimates of a fit.
//
// Noise that is white and alike at all times leaves estimates with the covariance s² H⁻¹, H = JᵀJ the normal
// matrix. Any other noise, of covariance C over the samples, leaves them with H⁻¹ Jᵀ C J H⁻¹ (the "sandwich",
// H. White, Econometrica 48, 817 (1980)). Here C_ij = s_i s_j rho(i, j): rho that of an autoregression over
// the steps of the record's grid, so that Jᵀ C J is the sum of squares of the Jacobian's columns, each times
// s, filtered as the noise is; gaps are zeros of the columns. This is right whatever frequencies an estimate
// lives at.
#pragma once

#include <span>
#include <vector>

#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/identify/least_squares/residual.h"
#include "cromer/identify/least_squares/sampling.h"

namespace cromer::core {

struct Noise {
  std::vector<double> scale;  ///< standard deviation of each sample over the mean one (rms); empty: all alike
  Autoregression correlation;  ///< of the residuals over their scale
  SampleGrid grid;
  double sum_of_squares = 0;  ///< of the residuals
  std::size_t samples = 0;

  /// White, and alike at all times.
  bool is_plain() const { return scale.empty() && correlation.coefficients.empty(); }
};

/// The standard deviation of each sample's noise over the mean one (rms), from residuals and the motion
/// that was fitted: s_i² = a + b x_i² + c v_i² (a sensor's gain, timing that is off), none of the three
/// negative. Empty (all alike) unless residuals of one variance would look like this in only one record of
/// a hundred.
std::vector<double> noise_scale(const SampleGrid& grid, std::span<const double> r,
                                std::span<const double> motion);

/// Of residuals and the motion that was fitted, each of the same length, given the grid of their times and
/// autocorrelations(r, grid, first_lags(r.size())).
Noise find_noise(const SampleGrid& grid, std::span<const double> r, std::span<const double> motion,
                 const std::vector<double>& rho);

/// What the noise does to a fit's estimates.
struct EstimateNoise {
  SquareMatrix covariance{};  // in the estimates' units
  Parameters degrees{};       ///< of freedom of each variance
};

/// `jacobian` holds the derivatives of the motion, sample by sample, with respect to `size` parameters.
/// Correlation never makes a variance smaller than independent samples would. `resolution` is the rounding
/// step of the values, 0 if unknown. Variances are infinite where the Jacobian is singular.
EstimateNoise estimate_noise(std::span<const double> jacobian, int size, const Noise& noise,
                             double resolution = 0);

}  // namespace cromer::core
