// A straight line through points that are uncertain in both coordinates.
#pragma once

#include <optional>
#include <vector>

namespace cromer::core {

struct UncertainPoint {
  double x = 0, y = 0;
  double x_error = 0, y_error = 0;  ///< standard uncertainties, >= 0, independent of each other
};

struct LineWithErrors {
  double slope = 0, intercept = 0;
  double slope_error = 0, intercept_error = 0;  ///< standard errors
  double covariance = 0;                        ///< of slope and intercept
  double chi_squared = 0;                       ///< with the errors given; degrees expected
  int degrees = 0;                              ///< of freedom, points less two
  double extra_scatter = 0;  ///< standard deviation in y added to every point so that chi_squared becomes
                             ///< degrees; 0 where the errors given explain the scatter
};

/// Least squares by D. York, N. M. Evensen, M. L. Martinez, J. De Basabe Delgado, Am. J. Phys. 72, 367
/// (2004). Points that scatter more than their errors say share a further scatter: R. C. Paule, J. Mandel,
/// J. Res. Natl. Bur. Stand. 87, 377 (1982). Empty with fewer than two points, two without errors, or all
/// x alike.
std::optional<LineWithErrors> fit_line_with_errors(const std::vector<UncertainPoint>& points);

}  // namespace cromer::core
