// What a minimum says of its parameters: covariance, intervals, residuals.
#pragma once

#include <span>

#include "cromer/identify/free_decay.h"
#include "cromer/identify/least_squares/normal_equations.h"

namespace cromer {

/// Euclidean norm of the values about their mean.
double centred_norm(std::span<const double> y);

/// Fills estimates, covariance and statistics of `fit` (whose law is set) from the inverse of the normal
/// matrix and the bias that rounding may have caused (see rounding_bias.h), both in the order of
/// fitted_parameters. Where the record does not determine a parameter its standard error is infinite, and the
/// status is iteration_limit with a message.
void describe_fit(FreeDecay& fit, const Record& record, const MotionParameters& motion,
                  const SquareMatrix& inverse_matrix, const Parameters& rounding_bias,
                  std::span<const double> residuals);

}  // namespace cromer
