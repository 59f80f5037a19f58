// How large the noise is, without a law.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

namespace cromer::core {

/// Standard deviation of what is independent from sample to sample: a second difference sees six times its
/// variance, and little of anything slow. 0 of fewer than three values.
inline double noise_of(std::span<const double> values) {
  if (values.size() < 3) return 0;
  double sum = 0;
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    const double d = values[i - 1] - 2 * values[i] + values[i + 1];
    sum += d * d;
  }
  return std::sqrt(sum / (6 * static_cast<double>(values.size() - 2)));
}

}  // namespace cromer::core
