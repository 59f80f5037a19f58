// Many response filters walked along one recording together: a lane for each, several packs of lanes in
// flight.
#pragma once

#include <cstddef>

namespace cromer {

/// Raw numbers in and out: the same for the units of every instruction set.
struct FilterWalk {
  const double* force;         ///< at the samples
  std::size_t samples;         ///< >= 2
  std::size_t substeps = 1;    ///< of an interval, in which the force is a ramp; >= 1
  bool hold = false;           ///< each sample until the next instead of a ramp
  bool every = true;           ///< look at the end of every substep, or at samples alone
  std::size_t look_every = 1;  ///< then at every so many samples
  std::size_t block = 32;      ///< intervals per block, >= 1
};

/// Lanes side by side, `filter_lanes()` of each: decay, kappa, e0, e2 (response_filter.h), then the state u,
/// d at the first sample.
struct FilterRows {
  const double *decay, *kappa, *e0, *e2, *u, *d;
};

/// Per block of intervals four rows of lanes: u and d at its beginning, least and greatest value in it.
inline constexpr std::size_t rows_per_block = 4;

/// How many lanes one walk takes.
std::size_t filter_lanes();

/// Walks all lanes along the recording and writes the rows of each block.
void walk_filters(const FilterWalk& walk, const FilterRows& rows, double* blocks);

}  // namespace cromer
