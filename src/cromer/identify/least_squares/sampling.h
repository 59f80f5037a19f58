// How a record is sampled: stretches of equal steps, and the places of all samples on one grid of such
// steps.
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

struct SampleGrid {
  double step = 1;                 ///< [s]
  std::vector<std::size_t> place;  ///< of each sample, increasing from 0; empty where sample i has place i

  bool has_gaps() const { return !place.empty(); }
  std::size_t at(std::size_t i) const { return place.empty() ? i : place[i]; }
};

/// Each sample stands as many places after the one before it as steps, to the nearest number, lie between
/// their times (strictly increasing): timing that jitters or is rounded makes no gap. The step is the mean of
/// those shorter than 1.75 medians. A gap has 600 places at most: nothing is correlated over more.
SampleGrid find_grid(std::span<const double> t);

}  // namespace cromer::core
