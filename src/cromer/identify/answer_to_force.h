// How the body of a fit answers a force, step by step: for the noise of a recorded one.
#pragma once

#include <optional>

#include "cromer/identify/law_fit.h"
#include "cromer/identify/least_squares/force_noise.h"

namespace cromer::core {

/// By the fitted law if it is linear, else by the linear law that is nearest to its force, on average over
/// the motion's samples (least squares). Per unit of the recorded force. Empty under hysteresis, where that
/// law does not damp, and where the record has a gap that the grid cuts short.
std::optional<AnswerToForce> answer_to_force(const LawFit& fit, const Record& record, const SampleGrid& grid);

/// By how much noise of variance 1 in each sample of a recorded force moves the estimates, on average: the
/// answer to the noise is not in the motion, and the least sum of squares is where the law answers it less.
/// With S = the answers' mean sum of squares, H⁻¹ grad S / 2, H⁻¹ the inverse of the normal matrix (of bias
/// by errors in variables: W. A. Fuller, Measurement Error Models (1987), chapter 1). By frequency, decay
/// rate and gain.
Parameters force_noise_bias(const LawFit& fit, const FittedParameters& fitted, const Record& record,
                            const SampleGrid& grid, const SquareMatrix& inverse_matrix);

}  // namespace cromer::core
