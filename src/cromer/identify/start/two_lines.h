// Two oscillations at once in a record, each with its own decay: two coupled swings, or a swing and what
// drives it.
//
//   y(t) = E + sum over both of exp(-g s) (A cos(w s) + B sin(w s)),   s from the first sample
//
// A linear oscillator under a harmonic drive moves like this too, with no decay of the drive's line.
#pragma once

#include <optional>
#include <vector>

#include "cromer/identify/least_squares/levenberg_marquardt.h"
#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/identify/record.h"

namespace cromer::core::two_lines {

/// Order of the parameters: E, and of each line what is named here. The second's decay rate comes last: of so
/// many parameters as `steady` it has none.
inline constexpr int first_of[] = {1, 5};
enum Place { frequency, cosine, sine, decay };
inline constexpr int decaying = 9, steady = 8;

/// What two decaying lines leave of each sample.
std::vector<double> residuals(const Record& record, const Parameters& p);

/// The same decaying lines with the level and amplitudes that fit best, which are linear. Empty where the
/// record cannot tell them.
std::optional<Parameters> with_amplitudes(const Record& record, Parameters p);

/// Least squares from there; scale as in LeastSquaresOptions.
LeastSquaresSummary fit(const Record& record, const Parameters& start, int size, double scale);

}  // namespace cromer::core::two_lines
