// The loop of filter_walk.h over packs of lanes; one unit for each instruction set includes it.
#pragma once

#include <cstddef>
#include <limits>

#include "cromer/analysis/response_filter.h"
#include "cromer/ensemble/filter_walk.h"

namespace cromer {

/// Pack: load(pointer), store(pointer), min, max, and the arithmetic of a number; `width` lanes of it.
template <class Pack, std::size_t in_flight>
struct FilterWalker {
  static constexpr std::size_t lanes = Pack::width * in_flight;

  ResponseFilter<Pack> filter[in_flight];
  FilterState<Pack> state[in_flight];
  Pack low[in_flight], high[in_flight];

  explicit FilterWalker(const FilterRows& rows) {
    for (std::size_t p = 0; p < in_flight; ++p) {
      const std::size_t at = p * Pack::width;
      filter[p] = {Pack::load(rows.decay + at), Pack::load(rows.kappa + at), Pack::load(rows.e0 + at),
                   Pack::load(rows.e2 + at), Pack(1.0)};
      state[p] = {Pack::load(rows.u + at), Pack::load(rows.d + at)};
    }
  }

  void pass(double force) {
    for (std::size_t p = 0; p < in_flight; ++p) filter[p].step(state[p], Pack(force));
  }
  void look(double force) {
    for (std::size_t p = 0; p < in_flight; ++p) {
      const Pack q = filter[p].step(state[p], Pack(force));
      low[p] = min(low[p], q);
      high[p] = max(high[p], q);
    }
  }

  void interval(const FilterWalk& walk, std::size_t i) {
    const double from = walk.force[i], to = walk.force[i + 1];
    const double rise = walk.hold ? 0 : (to - from) / static_cast<double>(walk.substeps);
    for (std::size_t j = 1; j < walk.substeps; ++j) {
      const double force = from + static_cast<double>(j) * rise;
      walk.every ? look(force) : pass(force);
    }
    walk.every || (i + 1) % walk.look_every == 0 ? look(to) : pass(to);
  }

  void run(const FilterWalk& walk, double* blocks) {
    const std::size_t intervals = walk.samples - 1;
    for (std::size_t begin = 0; begin < intervals; begin += walk.block, blocks += rows_per_block * lanes) {
      for (std::size_t p = 0; p < in_flight; ++p) {
        state[p].u.store(blocks + p * Pack::width);
        state[p].d.store(blocks + lanes + p * Pack::width);
        low[p] = Pack(std::numeric_limits<double>::infinity());
        high[p] = Pack(-std::numeric_limits<double>::infinity());
      }
      const std::size_t end = intervals - begin < walk.block ? intervals : begin + walk.block;
      if (walk.substeps == 1 && (walk.every || walk.look_every == 1))
        for (std::size_t i = begin; i < end; ++i) look(walk.force[i + 1]);
      else
        for (std::size_t i = begin; i < end; ++i) interval(walk, i);
      for (std::size_t p = 0; p < in_flight; ++p) {
        low[p].store(blocks + 2 * lanes + p * Pack::width);
        high[p].store(blocks + 3 * lanes + p * Pack::width);
      }
    }
  }
};

}  // namespace cromer
