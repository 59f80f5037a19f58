// Samples as places on a grid of equal steps: where a record has gaps, places are empty.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace cromer::core {

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
