// What a minimum says of its parameters: covariance, intervals, what the record does not determine.
#pragma once

#include <span>

#include "cromer/identify/law_fit.h"
#include "cromer/identify/least_squares/fit_settings.h"

namespace cromer {

/// Euclidean norm of the values about their mean.
double centred_norm(std::span<const double> y);

/// Where a fit ended.
struct Described {
  const FittedParameters& fitted;
  Parameters parameters{};       ///< at the minimum within the bounds
  Parameters without_bounds{};   ///< at the minimum without them
  SquareMatrix matrix{};         ///< JᵀJ there
  Parameters rounding_bias{};    ///< by how much rounding may have moved the parameters (rounding_bias.h)
  std::span<const double> residuals{};
  const SquareMatrix* inverse = nullptr;  ///< of the matrix, where it is known already
};

/// Fills parameters, covariance, intervals and statistics of `fit`, whose law and drive are set.
///
/// Variances are those of the residuals, of as many degrees of freedom as correlation leaves at the frequency
/// where a parameter lives; an equilibrium lives at zero frequency, all else at the swing's own. Rounding alone
/// leaves q^2/12: residuals below that only repeat the rounding's pattern. Intervals are centred on the minimum
/// without bounds, cut at their bound, and hold the estimate; what touches its bound is said.
///
/// Directions in which the sum of squares is flat to rounding, and those in which a parameter is unknown while a
/// ratio or product of it is known ten times as well, make the status undetermined: the message names them.
void describe_fit(LawFit& fit, const Record& record, const Described& minimum);

}  // namespace cromer
