// What noise of a recorded force does to the uncertainties of a fit.
#pragma once

#include <span>

#include "cromer/identify/describe_fit.h"
#include "cromer/identify/least_squares/noise.h"

namespace cromer::core {

/// The noise of the estimates, `known`, widened by what noise of the recorded force can do: of each the
/// larger variance, plus the bias. Sets `fit.force_noise`. Returns `known`, and leaves force_noise empty,
/// where the force has to be taken as exact: under hysteresis, where the nearest linear law does not damp,
/// and over a gap that the grid cuts short. `jacobian`: rows of fitted.count, sample by sample.
EstimateNoise with_noise_of_force(LawFit& fit, const Record& record, const DescribedMinimum& minimum,
                                  std::span<const double> jacobian, const SquareMatrix& inverse_matrix,
                                  const SampleGrid& grid, const EstimateNoise& known);

}  // namespace cromer::core
