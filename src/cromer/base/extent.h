// The lowest and the highest of some values.
#pragma once

#include <limits>
#include <span>

namespace cromer::core {

/// Of nothing `low` is infinite, and `high` its negative. NaN is left out.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};
Extent extent_of(std::span<const double> values);

}  // namespace cromer::core
