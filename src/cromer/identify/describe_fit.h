// What a minimum says of its parameters: covariance, intervals, what the record does not determine.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "cromer/identify/law_fit.h"
#include "cromer/identify/least_squares/normal_equations.h"

namespace cromer::core {

/// Where a fit ended.
struct DescribedMinimum {
  const FittedParameters& fitted;
  Parameters parameters{};      ///< within the bounds
  Parameters without_bounds{};  ///< where the sum of squares is least without them
  SquareMatrix matrix{};        ///< JᵀJ
  Parameters rounding_bias{};   ///< by how much rounding may have moved the parameters (noise.h)
  std::span<const double> residuals{};
  /// The Jacobian, sample by sample: called only where the noise is not plain.
  std::function<std::vector<double>()> jacobian{};
};

/// Fills parameters, covariance, intervals and statistics of `fit`, whose law and drive are set.
///
/// Covariances come from the residuals' noise (noise.h) and from what rounding may have done. Intervals are
/// centred on the minimum without bounds, cut at their bound, and hold the estimate. Notices name
/// parameters at their bound; where two dampings are traded for each other, they give the sum instead.
///
/// The status is undetermined where the sum of squares is flat to rounding in some direction, or where two
/// parameters are hardly known but their ratio is. The message names what is known instead.
void describe_fit(LawFit& fit, const Record& record, const DescribedMinimum& minimum);

}  // namespace cromer::core
