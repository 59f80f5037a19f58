// From the blocks of a walk to the extremes between its steps: only intervals that may hold one are looked
// into.
#pragma once

#include <cstddef>

#include "cromer/analysis/interval_peak.h"
#include "cromer/ensemble/filter_walk.h"

namespace cromer {

/// One oscillator of a walk.
struct WalkedLaw {
  LinearLaw<double> law;
  Watched<double> watched;
  IntervalMap<double> map;
  ResponseFilter<double> filter;
  double step;  // [s]
};

/// Its rows in what the walk left.
struct WalkedLane {
  const double* rows;
  std::size_t lanes;

  const double* block(std::size_t i) const { return rows + i * rows_per_block * lanes; }
  FilterState<double> state(std::size_t i) const { return {block(i)[0], block(i)[lanes]}; }
  double low(std::size_t i) const { return block(i)[2 * lanes]; }
  double high(std::size_t i) const { return block(i)[3 * lanes]; }
};

inline std::size_t blocks_of(const FilterWalk& walk) {
  return (walk.samples - 1 + walk.block - 1) / walk.block;
}

/// The extremes that the walk saw, and 0 for the beginning.
Extremes range_of(const FilterWalk& walk, const WalkedLaw& law, const WalkedLane& lane);

/// With those between its steps. Nothing is missed: a block is passed over only where a bound on how far the
/// quantity may rise between two steps says so.
Extremes refined(const FilterWalk& walk, const WalkedLaw& law, const WalkedLane& lane, Extremes range,
                 bool largest_alone);

/// The motion at the last sample (the end of its hold).
State<double> last_state(const FilterWalk& walk, const WalkedLaw& law, const WalkedLane& lane);

}  // namespace cromer
