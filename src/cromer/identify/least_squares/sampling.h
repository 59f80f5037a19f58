// How the times of a record lie: stretches of equal steps, and the rest.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace cromer::core {

/// Consecutive samples [first, first + count). Where `uniform`, t[first + n] = t[first] + n h to a billionth
/// of h, h the record's median step.
struct Stretch {
  std::size_t first = 0;
  std::size_t count = 0;
  bool uniform = false;
};

struct Sampling {
  double step = 0;                 // [s] median of the steps
  std::vector<Stretch> stretches;  ///< in order, none longer than longest_stretch, together all samples
};

/// Longest stretch: a recurrence over it loses no digits, and a table of it stays in the first-level cache.
inline constexpr std::size_t longest_stretch = 256;

/// [s] The median of the steps; of equal steps their mean. At least two times.
double median_step(std::span<const double> t);

/// Cuts a record's times (strictly increasing) into stretches.
Sampling find_sampling(std::span<const double> t);

}  // namespace cromer::core
