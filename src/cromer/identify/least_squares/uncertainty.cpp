#include "cromer/identify/least_squares/uncertainty.h"

#include <algorithm>

#include "cromer/identify/least_squares/student.h"

namespace cromer::core {

double student_95(double degrees) {
  if (degrees > 1e6) return 1.959964;
  return student_quantile(0.975, std::max(1.0, degrees));
}

Estimate make_estimate(double value, double standard_error, double t) {
  return {value, standard_error, value - t * standard_error, value + t * standard_error};
}

}  // namespace cromer::core
