// From a covariance to what is said of a number.
#pragma once

#include "cromer/quantity.h"

namespace cromer::core {

/// Student's t that 95 % of the distribution with `degrees` > 0 of freedom lie within; at least one degree is
/// assumed.
double student_95(double degrees);

/// The estimate with its symmetric interval value ± t * standard_error.
Estimate make_estimate(double value, double standard_error, double t);

}  // namespace cromer::core
