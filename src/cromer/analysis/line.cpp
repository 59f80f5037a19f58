#include "cromer/analysis/line.h"

#include <algorithm>
#include <cmath>

#include "cromer/base/extent.h"

namespace cromer::core {
namespace {

struct Weighted {
  double slope, intercept, slope_variance, intercept_variance, covariance, chi_squared;
};

/// York's iteration from `slope`; `extra` is a variance of every y. Some error is not 0 at every point.
Weighted york(const std::vector<UncertainPoint>& points, double slope, double extra) {
  const std::size_t n = points.size();
  std::vector<double> weight(n), beta(n);
  double mean_x = 0, mean_y = 0, sum = 0;
  for (int round = 0; round < 200; ++round) {
    sum = mean_x = mean_y = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const UncertainPoint& p = points[i];
      weight[i] = 1 / (p.y_error * p.y_error + extra + slope * slope * p.x_error * p.x_error);
      sum += weight[i];
      mean_x += weight[i] * p.x;
      mean_y += weight[i] * p.y;
    }
    mean_x /= sum;
    mean_y /= sum;
    double above = 0, below = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const UncertainPoint& p = points[i];
      const double U = p.x - mean_x, V = p.y - mean_y;
      beta[i] = weight[i] * (U * (p.y_error * p.y_error + extra) + slope * V * p.x_error * p.x_error);
      above += weight[i] * beta[i] * V;
      below += weight[i] * beta[i] * U;
    }
    const double next = above / below;
    const bool settled = std::abs(next - slope) <= 1e-14 * std::abs(next);
    slope = next;
    if (settled) break;
  }
  // Errors from the adjusted points, York et al. (2004), eq. 13.
  double adjusted_mean = 0;
  for (std::size_t i = 0; i < n; ++i) adjusted_mean += weight[i] * (mean_x + beta[i]) / sum;
  double spread = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double u = mean_x + beta[i] - adjusted_mean;
    spread += weight[i] * u * u;
  }
  Weighted line{slope, mean_y - slope * mean_x, 1 / spread, 0, 0, 0};
  line.intercept_variance = 1 / sum + adjusted_mean * adjusted_mean * line.slope_variance;
  line.covariance = -adjusted_mean * line.slope_variance;
  for (std::size_t i = 0; i < n; ++i) {
    const double rest = points[i].y - line.intercept - slope * points[i].x;
    line.chi_squared += weight[i] * rest * rest;
  }
  return line;
}

}  // namespace

std::optional<LineWithErrors> fit_line_with_errors(const std::vector<UncertainPoint>& points) {
  const std::size_t n = points.size();
  std::vector<double> x, y;
  double error_free = 0;
  for (const UncertainPoint& p : points) {
    x.push_back(p.x);
    y.push_back(p.y);
    error_free += !(p.x_error > 0 || p.y_error > 0);
  }
  if (n < 2 || (n == 2 && error_free > 0)) return std::nullopt;
  const auto [low, high] = extent_of(x);
  if (!(high > low)) return std::nullopt;

  const Line plain = fit_line(x, y);
  double rest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double r = y[i] - plain.intercept - plain.slope * x[i];
    rest += r * r;
  }
  const int degrees = static_cast<int>(n) - 2;
  // With no errors given the scatter about the line is all there is to go by.
  const double unweighted = degrees > 0 ? rest / degrees : 0;
  const double least = error_free > 0 ? std::max(1e-12 * unweighted, 1e-300) : 0;
  Weighted line = york(points, plain.slope, least);
  LineWithErrors result;
  result.degrees = degrees;
  result.chi_squared = line.chi_squared;
  double extra = 0;
  if (degrees > 0 && line.chi_squared > degrees) {
    double below = least, above = std::max(unweighted, 1e-300);
    while (york(points, plain.slope, above).chi_squared > degrees) above *= 4;
    for (int i = 0; i < 100; ++i) {
      extra = 0.5 * (below + above);
      (york(points, plain.slope, extra).chi_squared > degrees ? below : above) = extra;
    }
    line = york(points, plain.slope, extra);
  }
  result.slope = line.slope;
  result.intercept = line.intercept;
  result.slope_error = std::sqrt(line.slope_variance);
  result.intercept_error = std::sqrt(line.intercept_variance);
  result.covariance = line.covariance;
  result.extra_scatter = std::sqrt(extra);
  return result;
}

}  // namespace cromer::core
