#include "cromer/identify/uncertainty.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>

namespace cromer {

double student_95(double degrees) {
  if (degrees > 1e6) return 1.959964;
  return boost::math::quantile(boost::math::students_t(std::max(1.0, degrees)), 0.975);
}

Estimate make_estimate(double value, double standard_error, double t) {
  return {value, standard_error, value - t * standard_error, value + t * standard_error};
}

}  // namespace cromer
