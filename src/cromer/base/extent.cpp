#include "cromer/base/extent.h"

#include <algorithm>
#include <cstddef>

namespace cromer::core {

Extent extent_of(std::span<const double> values) {
  // In lanes, as each comparison waits for the one before it.
  constexpr std::size_t lanes = 8;
  constexpr Extent nothing;
  double low[lanes], high[lanes];
  std::fill_n(low, lanes, nothing.low);
  std::fill_n(high, lanes, nothing.high);
  std::size_t i = 0;
  for (; i + lanes <= values.size(); i += lanes)
    for (std::size_t l = 0; l < lanes; ++l) {
      low[l] = std::min(low[l], values[i + l]);
      high[l] = std::max(high[l], values[i + l]);
    }
  for (; i < values.size(); ++i) {
    low[0] = std::min(low[0], values[i]);
    high[0] = std::max(high[0], values[i]);
  }
  return {*std::min_element(low, low + lanes), *std::max_element(high, high + lanes)};
}

}  // namespace cromer::core
