// Quantiles of some values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace cromer::core {

/// The value that this share of the values is below, 0 <= share < 1: of n sorted values the one at place
/// share n, counted from 0. Reorders the values. There must be at least one, and no NaN among them.
inline double quantile(std::span<double> values, double share) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// The middle value; of an even number of values the upper of the two in the middle. As quantile().
inline double upper_median(std::span<double> values) { return quantile(values, 0.5); }

/// The middle value, or the mean of the two in the middle; NaN of nothing. Takes a copy on purpose.
inline double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double upper = upper_median(values);
  if (values.size() % 2 == 1) return upper;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  return (upper + *std::max_element(values.begin(), middle)) / 2;
}

}  // namespace cromer::core
