// The middle of some values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace cromer::core {

/// The middle value; of an even number of values the upper of the two in the middle. Reorders the values.
/// There must be at least one, and no NaN among them.
inline double upper_median(std::span<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace cromer::core
