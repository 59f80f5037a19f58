// A straight line through points, by least squares.
#pragma once

#include <cstddef>
#include <span>

namespace cromer::core {

struct Line {
  double slope = 0;
  double intercept = 0;
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

}  // namespace cromer::core
