// The noise of a record as its residuals show it, and what it and the sensor's rounding do to the estimates
// of a fit.
//
// Noise that is white and alike at all times leaves estimates with the covariance s² H⁻¹, H = JᵀJ the normal
// matrix. Any other noise, of covariance C over the samples, leaves them with H⁻¹ Jᵀ C J H⁻¹ (the "sandwich",
// H. White, Econometrica 48, 817 (1980)). Here C_ij = s_i s_j rho(i, j): rho that of an autoregression over
// the steps of the record's grid, so that Jᵀ C J is the sum of squares of the Jacobian's columns, each times
// s, filtered as the noise is; gaps are zeros of the columns. This is right whatever frequencies an estimate
// lives at. s_i follows the motion (a sensor's gain, timing that is off) or, where the noise is larger at one
// time than at another, the residuals of the samples around.
#pragma once

#include <span>
#include <vector>

#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/identify/least_squares/residual.h"
#include "cromer/identify/least_squares/sampling.h"
#include "cromer/identify/record.h"

namespace cromer::core {

struct Noise {
  std::vector<double> scale;  ///< standard deviation of each sample over the mean one (rms); empty: all alike
  std::size_t stretch = 0;    ///< of so many samples each is known; 0: of all, by the motion
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

/// The same from the residuals alone, of noise that is larger at one time than at another: the rms of
/// stretches of stretch_of() samples. Empty unless even noise, whose squares correlate as those of normal
/// noise with the autocorrelations `rho`, would differ so from stretch to stretch in only one record of a
/// thousand, and where the residuals over it are not white: what a wrong law leaves is uneven too.
std::vector<double> scale_along(const SampleGrid& grid, std::span<const double> r,
                                const std::vector<double>& rho);

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

/// What the noise does to quantities that are sums over the samples, each for itself.
struct SumNoise {
  Parameters variance{};
  Parameters degrees{};  ///< of freedom of each variance
};

/// `effects` holds what each sample adds to the quantities, sample by sample; of at most max_parameters.
/// Without degrees of freedom it takes a third of the time.
SumNoise noise_of_sums(std::span<const double> effects, int size, const Noise& noise, bool with_degrees);

// Rounding, where the noise is too small to blur the sensor's steps.

/// Expected rounding error (rounded minus exact) of a value with normal noise, in steps of 1:
///   sum over k of (-1)^k sin(2 pi k value) exp(-2 pi² k² noise²) / (pi k).
/// Widrow & Kollár, Quantization Noise (2008), chapter 4. Exact below a noise of 0.05, where no noise is
/// assumed.
double expected_rounding_error(double value, double noise);

/// The fitted motion with the rounding errors that the sensor would make of it: a fit of these values is
/// off by as much as rounding may have moved the record's own fit. The errors repeat with each period, so
/// they do not average out. `residuals` are the record's minus the fit. Empty where the resolution is
/// unknown, or the noise blurs it (rms > 0.6 resolution).
std::vector<double> rounded_motion(const Record& record, std::span<const double> residuals);

}  // namespace cromer::core
