// A motion that dry friction brings to rest has a minimum of the sum of squares for each number of half
// swings.
//
// As the friction f grows, the place of rest moves from one end of the band |x| <= f/w0² that friction holds
// to the other, and back again once the motion has lost a half swing: a rest seen in one place is reached
// with many values of f. The swing before must tell which it was, and may not be able to.
#pragma once

#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/identify/fit_settings.h"
#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// `found` and the minima on either side of it, as far as the record does not rule them out (their sum of
/// squares is not above the lowest by 25 variances or more); the lowest comes first. `found` alone where the
/// motion does not come to rest before the record's last period. Steps of at most h [s].
std::vector<LeastSquaresSummary> rest_minima(const Record& record, const FittedParameters& fitted,
                                             const LeastSquaresSummary& found,
                                             const LeastSquaresOptions& options, double h,
                                             const Watch& watch);

/// The minimum along an end of the band, for an iteration that ended there unsettled: a rest seen beyond the
/// band has its least squares where two numbers of half swings meet, and the slope jumps. `found` itself
/// where that is not so.
LeastSquaresSummary end_of_band_minimum(const Record& record, const FittedParameters& fitted,
                                        const LeastSquaresSummary& found, const LeastSquaresOptions& options,
                                        double h, const Watch& watch);

/// Spreads intervals, standard errors and covariance of a described fit over several minima: the 95 % in the
/// middle of Student's distributions about each, weighted by Laplace's approximation of their likelihoods
/// (L. Tierney & J. B. Kadane, J. Am. Stat. Assoc. 81, 82 (1986)). The fit is the one of minima.front(). A
/// notice says so where another minimum has a weight of a twentieth or more.
void spread_over(LawFit& fit, const FittedParameters& fitted, const std::vector<LeastSquaresSummary>& minima);

}  // namespace cromer::core
