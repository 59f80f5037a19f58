// The middle of some values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace cromer::core {

/// The value in the middle, of an even number of them the upper of the two; their order changes. `values` is
/// not empty and holds no NaN.
inline double upper_median(std::span<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace cromer::core
