// Straight lines through points, by least squares: points that are exact in x, and points that are uncertain
// in both coordinates.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace cromer::core {

struct Line {
  double slope = 0;
  double intercept = 0;

  double at(double x) const { return intercept + slope * x; }
};

/// x and y of the same length, at least two different x. Means first, so that far-off origins lose no digits.
inline Line fit_line(std::span<const double> x, std::span<const double> y) {
  const auto n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / n;
    mean_y += y[i] / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += (x[i] - mean_x) * (x[i] - mean_x);
    sxy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  const double slope = sxy / sxx;
  return {slope, mean_y - slope * mean_x};
}

struct UncertainPoint {
  double x = 0, y = 0;
  double x_error = 0, y_error = 0;  ///< standard uncertainties, >= 0, independent of each other
};

struct LineWithErrors : Line {
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
