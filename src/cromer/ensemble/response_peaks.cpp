#include "cromer/ensemble/response_peaks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "cromer/ensemble/filter_walk.h"
#include "cromer/ensemble/refine_peaks.h"

namespace cromer {
namespace {

double period_of(const LinearLaw<double>& law) { return 2 * std::numbers::pi / std::sqrt(law.stiffness); }

Watched<double> watched_of(const LinearLaw<double>& law, ResponseOf quantity) {
  // On the mirrored motion, driven by +a: the absolute acceleration is what spring and damper give it.
  return quantity == ResponseOf::displacement ? Watched<double>{1, 0}
                                              : Watched<double>{law.stiffness, 2 * law.decay_rate};
}

/// Laws that are walked together, and what the walk leaves.
class Group {
 public:
  Group() : lanes_(filter_lanes()), rows_(6 * lanes_) {}

  void set(std::size_t lane, const ResponseFilter<double>& filter, const FilterState<double>& start) {
    const double values[] = {filter.decay, filter.kappa, filter.e0, filter.e2, start.u, start.d};
    for (std::size_t row = 0; row < 6; ++row) rows_[row * lanes_ + lane] = values[row];
  }
  /// Lanes without a law repeat the first.
  void fill_from(std::size_t lane) {
    for (; lane < lanes_; ++lane)
      for (std::size_t row = 0; row < 6; ++row) rows_[row * lanes_ + lane] = rows_[row * lanes_];
  }
  void walk(const FilterWalk& walk) {
    const std::size_t count = (walk.samples - 1 + walk.block - 1) / walk.block;
    blocks_.resize(count * rows_per_block * lanes_);
    const double* r = rows_.data();
    const std::size_t n = lanes_;
    walk_filters(walk, {r, r + n, r + 2 * n, r + 3 * n, r + 4 * n, r + 5 * n}, blocks_.data());
  }
  WalkedLane lane(std::size_t lane) const { return {blocks_.data() + lane, lanes_}; }
  std::size_t lanes() const { return lanes_; }

 private:
  std::size_t lanes_;
  std::vector<double> rows_, blocks_;
};

/// Blocks of about 32 steps, and not too many of them.
std::size_t block_length(std::size_t samples, std::size_t steps) {
  return std::max({std::size_t{1}, 32 / steps, samples / 8192});
}

}  // namespace

std::size_t substeps(double spacing, double period) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(10 * spacing / period - 1e-9)));
}

std::vector<ResponsePeaks> response_peaks(const GroundMotion& ground, std::span<const LinearLaw<double>> laws,
                                          ResponseOf quantity, Peaks peaks, bool largest_alone) {
  std::vector<double> samples(ground.acceleration.begin(), ground.acceleration.end());
  const bool hold = ground.between == BetweenSamples::hold;
  if (hold) samples.push_back(samples.back());

  std::vector<std::size_t> steps(laws.size()), order(laws.size());
  for (std::size_t i = 0; i < laws.size(); ++i) steps[i] = substeps(ground.spacing, period_of(laws[i]));
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return steps[a] < steps[b]; });

  std::vector<ResponsePeaks> found(laws.size());
  Group group;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    // The finest of them sets the steps of all, but where the steps are part of the definition.
    end = std::min(begin + group.lanes(), order.size());
    if (peaks == Peaks::peer)
      while (steps[order[end - 1]] != steps[order[begin]]) --end;
    const std::size_t most = steps[order[end - 1]];
    const FilterWalk walk{samples.data(),
                          samples.size(),
                          most,
                          hold,
                          peaks != Peaks::samples,
                          ground.refinement,
                          block_length(samples.size(), most)};
    const double h = ground.spacing / static_cast<double>(most);

    std::vector<WalkedLaw> walked;
    for (std::size_t i = begin; i < end; ++i) {
      const LinearLaw<double>& law = laws[order[i]];
      const IntervalMap<double> map = interval_map(law, h, hold);
      const Watched<double> watched = watched_of(law, quantity);
      walked.push_back({law, watched, map, response_filter(map, watched), h});
      group.set(i - begin, walked.back().filter, at_rest(map, samples.front()));
    }
    group.fill_from(end - begin);
    group.walk(walk);
    for (std::size_t i = begin; i < end; ++i) {
      const WalkedLaw& law = walked[i - begin];
      const WalkedLane lane = group.lane(i - begin);
      Extremes range = range_of(walk, law, lane);
      if (peaks == Peaks::continuous) range = refined(walk, law, lane, range, largest_alone);
      ResponsePeaks& result = found[order[i]];
      result.during = range;
      const State<double> last = last_state(walk, law, lane);
      result.after = {law.watched.x * last.x + law.watched.v * last.v,
                      law.watched.x * last.x + law.watched.v * last.v};
      include_free(law.law, law.watched, last, result.after);
    }
  }
  return found;
}

}  // namespace cromer
