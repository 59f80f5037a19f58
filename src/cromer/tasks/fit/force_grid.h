// Where the samples of a motion lie among those of the force that was recorded with it.
#pragma once

#include <cstddef>
#include <vector>

#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core {

/// An even grid of times, by the force's own samples.
struct ForceGrid {
  double begin = 0;    // [s]
  double spacing = 1;  // [s] > 0
  std::size_t size = 0;

  double time(std::size_t i) const { return begin + static_cast<double>(i) * spacing; }
};

/// The part of a force column from one time to another [s], with the margin that its reading between the
/// samples wants, as far as that has no gap.
Series force_around(const Series& force, double from, double to);

/// The grid of a force column. An Error where it has gaps, uneven times, or one value throughout.
Result<ForceGrid> grid_of(const Series& force);

/// Each sample's place on the grid. An Error where one has none.
Result<std::vector<std::size_t>> places_on(const ForceGrid& grid, const Series& motion, const Series& force);

}  // namespace cromer::core
