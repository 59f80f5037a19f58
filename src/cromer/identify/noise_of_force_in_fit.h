// What noise of a recorded force does to the uncertainties of a fit.
#pragma once

#include <span>

#include "cromer/identify/describe_fit.h"
#include "cromer/identify/least_squares/noise.h"

namespace cromer::core {

/// The noise of the estimates with what noise of the force there may be, of each the larger, and the bias
/// that it makes. What was seen of it goes to `fit`, which holds the motion, the law and the force. `known`
/// leaves it out, and is returned where the force has to be taken as exact: under hysteresis, where the
/// linear law that is nearest does not damp, and over a gap that the grid cuts short.
EstimateNoise with_noise_of_force(LawFit& fit, const Record& record, const DescribedMinimum& minimum,
                                  std::span<const double> jacobian, const SquareMatrix& inverse_matrix,
                                  const SampleGrid& grid, const EstimateNoise& known);

}  // namespace cromer::core
