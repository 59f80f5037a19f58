#include "cromer/ensemble/response_peaks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "cromer/ensemble/dispatch.h"
#include "cromer/ensemble/refine_peaks.h"

namespace cromer::core {
namespace {

double period_of(const LinearLaw<double>& law) { return 2 * std::numbers::pi / std::sqrt(law.stiffness); }

Watched<double> watched_of(const LinearLaw<double>& law, ResponseOf quantity) {
  // On the mirrored motion, driven by +a: the absolute acceleration is what spring and damper give it.
  return quantity == ResponseOf::displacement ? Watched<double>{1, 0}
                                              : Watched<double>{law.stiffness, 2 * law.decay_rate};
}

/// Blocks of about 32 steps, and not too many of them.
std::size_t block_length(std::size_t samples, std::size_t steps) {
  return std::max({std::size_t{1}, 32 / steps, samples / 8192});
}

/// Laws that are walked together, and what the walk leaves.
struct Group {
  cromer_walk::Filters filters{};
  std::vector<WalkedLaw> laws{};
  std::vector<cromer_walk::Block> blocks{};

  /// Its memory stays for the next laws.
  void clear() {
    filters = {};
    laws.clear();
  }
  void add(const LinearLaw<double>& law, const Watched<double>& watched, double step, bool hold,
           double force) {
    const IntervalMap<double> map = interval_map(law, step, hold);
    const ResponseFilter<double> filter = response_filter(map, watched);
    const FilterState<double> start = at_rest(map, force);
    const std::size_t lane = laws.size();
    filters.decay.of[lane] = filter.decay;
    filters.kappa.of[lane] = filter.kappa;
    filters.e0.of[lane] = filter.e0;
    filters.e2.of[lane] = filter.e2;
    filters.u.of[lane] = start.u;
    filters.d.of[lane] = start.d;
    laws.push_back({law, watched, map, filter, step});
  }
  /// Lanes without a law rest: their filters are 0.
  void walk(const cromer_walk::Walk& walk, cromer_walk::Function function) {
    blocks.resize(walk.blocks());
    function(filters, walk, blocks.data());
  }
};

ResponsePeaks peaks_of(const Group& group, std::size_t lane_of, const cromer_walk::Walk& walk,
                       std::span<const double> forces, const PeakSearch& search) {
  const WalkedLaw& law = group.laws[lane_of];
  const WalkedLane lane{group.blocks.data(), lane_of};
  ResponsePeaks found{search.peaks == Peaks::continuous
                          ? refined(walk, forces, law, lane, search.largest_alone)
                          : range_of(walk, law, lane),
                      {0, 0}};
  if (!search.after_the_end) return found;
  const State<double> last = last_state(walk, law, lane);
  const double q = law.watched.x * last.x + law.watched.v * last.v;
  found.after = {q, q};
  // The energy of a free motion only falls: it may be clear that it cannot swing as far again.
  const double farthest = std::hypot(last.x, last.v / std::sqrt(law.law.stiffness));
  const bool no_farther = search.largest_alone && law.watched.v == 0 &&
                          std::abs(law.watched.x) * farthest <= found.during.magnitude();
  if (!no_farther) include_free(law.law, law.watched, last, found.after);
  return found;
}

}  // namespace

std::size_t substeps(double spacing, double period) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(10 * spacing / period - 1e-9)));
}

std::vector<ResponsePeaks> response_peaks(const GroundMotion& ground, std::span<const LinearLaw<double>> laws,
                                          const PeakSearch& search) {
  std::vector<double> samples(ground.acceleration.begin(), ground.acceleration.end());
  const cromer_walk::Function walk_filters = search.walk ? search.walk : units_here().back().walk;
  const bool hold = ground.between == BetweenSamples::hold;
  if (hold) samples.push_back(samples.back());

  std::vector<std::size_t> steps(laws.size()), order(laws.size());
  for (std::size_t i = 0; i < laws.size(); ++i) steps[i] = substeps(ground.spacing, period_of(laws[i]));
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return steps[a] < steps[b]; });

  std::vector<ResponsePeaks> found(laws.size());
  std::vector<double> forces;
  std::size_t block_of_forces = 0;
  Group group;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    // The finest of them sets the steps of all, but where the steps are part of the definition.
    end = std::min(begin + cromer_walk::lanes, order.size());
    if (search.peaks == Peaks::peer)
      while (steps[order[end - 1]] != steps[order[begin]]) --end;
    const std::size_t most = steps[order[end - 1]];
    const cromer_walk::Walk walk{.force = samples.data(),
                                 .samples = samples.size(),
                                 .substeps = most,
                                 .hold = hold,
                                 .every = search.peaks != Peaks::samples,
                                 .look_every = ground.refinement,
                                 .block = block_length(samples.size(), most)};
    group.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const LinearLaw<double>& law = laws[order[i]];
      group.add(law, watched_of(law, search.quantity), ground.spacing / static_cast<double>(most), hold,
                samples.front());
    }
    group.walk(walk, walk_filters);
    if (block_of_forces != walk.block) forces = largest_forces(walk);
    block_of_forces = walk.block;
    for (std::size_t i = begin; i < end; ++i)
      found[order[i]] = peaks_of(group, i - begin, walk, forces, search);
  }
  return found;
}

}  // namespace cromer::core
