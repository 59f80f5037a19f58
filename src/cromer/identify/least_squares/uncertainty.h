// Student's t, for any real number of degrees of freedom >= 1, and the intervals that follow from it.
//
// Biometrika 6, 1 (1908). The tail is half an incomplete beta function, here by the continued fraction of
// DLMF 8.17.22 (https://dlmf.nist.gov/8.17).
#pragma once

#include "cromer/quantity.h"

namespace cromer::core {

/// The probability of values below t. Relative error of the smaller tail: 1e-12 to ten
/// thousand degrees, 1e-10 to a million.
double student_cdf(double t, double degrees);

/// The value below which the probability is p, 1/2 <= p < 1. Relative error as above, where 1 - p has the
/// digits for it.
double student_quantile(double p, double degrees);

/// Student's t within which 95 % of the distribution with `degrees` > 0 of freedom lie; at least one degree
/// is assumed.
double student_95(double degrees);

/// The estimate with its symmetric interval value ± t * standard_error.
Estimate make_estimate(double value, double standard_error, double t);

}  // namespace cromer::core
