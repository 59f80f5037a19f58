// The walk of filter_walk.h for one instruction set: the loop over packs of lanes. A unit defines CROMER_UNIT
// and CROMER_PACK_ARCH as for unit.h, where the reason for the namespaces stands; its function is
// cromer_walk_NAME, which tells what the unit does.
#define CROMER_JOINED(a, b) a##_##b
#define CROMER_JOIN(a, b) CROMER_JOINED(a, b)
#define cromer CROMER_JOIN(cromer_in, CROMER_UNIT)
#define xsimd CROMER_JOIN(xsimd_in, CROMER_UNIT)

#include <cstddef>
#include <limits>

#include "cromer/analysis/response_filter.h"
#include "cromer/ensemble/filter_walk.h"
#include "cromer/ensemble/pack.h"
#include "cromer/ensemble/units/two_components.h"

namespace cromer::core {

/// Packs walked together: the chain from one step to the next has the latency of two operations, and other
/// packs fill it.
inline constexpr std::size_t in_flight = 3;

template <class Pack>
struct FilterLanes {
  ResponseFilter<Pack> filter[in_flight];
  FilterState<Pack> state[in_flight];
  Pack low[in_flight], high[in_flight];

  FilterLanes(const cromer_walk::Filters& filters, std::size_t first) {
    for (std::size_t p = 0; p < in_flight; ++p) {
      const auto load = [&](const cromer_walk::Numbers& numbers) {
        return Pack::load(numbers.of + first + p * Pack::size);
      };
      filter[p] = {load(filters.decay), load(filters.kappa), load(filters.e0), load(filters.e2), Pack(1.0)};
      state[p] = {load(filters.u), load(filters.d)};
    }
  }

  void pass(double force) {
    const Pack f(force);
    for (std::size_t p = 0; p < in_flight; ++p) filter[p].step(state[p], f);
  }
  void look(double force) {
    const Pack f(force);
    for (std::size_t p = 0; p < in_flight; ++p) {
      const Pack q = filter[p].step(state[p], f);
      low[p] = smaller(low[p], q);
      high[p] = larger(high[p], q);
    }
  }

  void interval(const cromer_walk::Walk& walk, std::size_t i) {
    const double from = walk.force[i], to = walk.force[i + 1];
    const double rise = walk.hold ? 0 : (to - from) / static_cast<double>(walk.substeps);
    for (std::size_t j = 1; j < walk.substeps; ++j) {
      const double force = from + static_cast<double>(j) * rise;
      walk.every ? look(force) : pass(force);
    }
    walk.every || (i + 1) % walk.look_every == 0 ? look(to) : pass(to);
  }

  void run(const cromer_walk::Walk& walk, std::size_t first, cromer_walk::Block* blocks) {
    const std::size_t intervals = walk.samples - 1;
    const bool plain = walk.substeps == 1 && (walk.every || walk.look_every == 1);
    for (std::size_t begin = 0; begin < intervals; begin += walk.block, ++blocks) {
      for (std::size_t p = 0; p < in_flight; ++p) {
        state[p].u.store(blocks->u.of + first + p * Pack::size);
        state[p].d.store(blocks->d.of + first + p * Pack::size);
        low[p] = Pack(std::numeric_limits<double>::infinity());
        high[p] = Pack(-std::numeric_limits<double>::infinity());
      }
      const std::size_t end = intervals - begin < walk.block ? intervals : begin + walk.block;
      if (plain)
        for (std::size_t i = begin; i < end; ++i) look(walk.force[i + 1]);
      else
        for (std::size_t i = begin; i < end; ++i) interval(walk, i);
      for (std::size_t p = 0; p < in_flight; ++p) {
        low[p].store(blocks->low.of + first + p * Pack::size);
        high[p].store(blocks->high.of + first + p * Pack::size);
      }
    }
  }
};

/// All lanes of a walk.
template <class Pack>
void walk_lanes(const cromer_walk::Filters& filters, const cromer_walk::Walk& walk,
                cromer_walk::Block* blocks) {
  static_assert(cromer_walk::lanes % (in_flight * Pack::size) == 0);
  for (std::size_t first = 0; first < cromer_walk::lanes; first += in_flight * Pack::size)
    FilterLanes<Pack>(filters, first).run(walk, first, blocks);
}

}  // namespace cromer::core

cromer_walk::Functions CROMER_JOIN(cromer_walk, CROMER_UNIT)() {
  using Pack = cromer::core::Pack<CROMER_PACK_ARCH>;
  return {cromer::core::walk_lanes<Pack>, cromer::core::walk_two<Pack>, cromer::core::reach_of_points<Pack>,
          cromer::core::reach_of_path<Pack>};
}
