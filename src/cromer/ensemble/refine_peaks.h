// From the blocks of a walk to the extremes between its steps: only intervals that may hold one are looked
// into.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cromer/analysis/interval_peak.h"
#include "cromer/ensemble/filter_walk.h"

namespace cromer::core {

/// One oscillator of a walk.
struct WalkedLaw {
  LinearLaw<double> law;
  Watched<double> watched;
  IntervalMap<double> map;
  ResponseFilter<double> filter;
  double step;  // [s]
};

/// Its lane of what the walk left.
struct WalkedLane {
  const cromer_walk::Block* blocks;
  std::size_t lane;

  FilterState<double> state(std::size_t i) const { return {blocks[i].u.of[lane], blocks[i].d.of[lane]}; }
  double low(std::size_t i) const { return blocks[i].low.of[lane]; }
  double high(std::size_t i) const { return blocks[i].high.of[lane]; }
};

/// The extremes that the walk saw, and 0 for the beginning.
Extremes range_of(const cromer_walk::Walk& walk, const WalkedLaw& law, const WalkedLane& lane);

/// Largest |force| in each block, the next sample included.
std::vector<double> largest_forces(const cromer_walk::Walk& walk);

/// The same with those between its steps. Nothing is missed: a block is passed over only where a bound on how
/// far the quantity may rise between two steps says so.
Extremes refined(const cromer_walk::Walk& walk, std::span<const double> largest_forces, const WalkedLaw& law,
                 const WalkedLane& lane, bool largest_alone);

/// The motion at the last sample (the end of its hold).
State<double> last_state(const cromer_walk::Walk& walk, const WalkedLaw& law, const WalkedLane& lane);

}  // namespace cromer::core
