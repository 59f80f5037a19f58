#include "cromer/ensemble/walked_laws.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cromer/analysis/interval_peak.h"
#include "cromer/base/pi.h"

namespace cromer::core {
namespace {

/// Blocks of about 32 steps, and not too many of them.
std::size_t block_length(std::size_t samples, std::size_t steps) {
  return std::max({std::size_t{1}, 32 / steps, samples / 8192});
}

}  // namespace

double period_of(const LinearLaw<double>& law) { return two_pi / std::sqrt(law.stiffness); }

ResponseQuantity<double> quantity_of(const LinearLaw<double>& law, ResponseOf of) {
  switch (of) {
    case ResponseOf::displacement:
      return {1, 0};
    case ResponseOf::velocity:
      return {0, 1};
    default:
      return {law.stiffness, 2 * law.decay_rate};
  }
}

BlockBound::BlockBound(const WalkedLaw& w, std::size_t substeps, bool hold) {
  // A displacement leaves its chord by at most h^2/8 of the largest |q''| = |f - 2 b q' - s q|. In there
  // |q| exceeds its bound by no more than that, and |q'| the mean slope by no more than h |q''|.
  const double h = w.step, bow = h * h / 8;
  const double left = 1 - w.law.stiffness * bow - 2 * w.law.decay_rate * h;
  if (w.quantity.v == 0 && left > 0.5) {
    of_q = bow * (w.law.stiffness + 4 * w.law.decay_rate / h) / left;
    of_force = bow * std::abs(w.quantity.x) / left;
  } else {
    by_state(w, substeps, hold);
  }
}

/// overshoot_bound, the state at the beginning being a linear function of both.
void BlockBound::by_state(const WalkedLaw& w, std::size_t substeps, bool hold) {
  const IntervalMap<double>& m = w.map;
  const ResponseQuantity<double>& o = w.quantity;
  // q and the next q (without what the force does meanwhile) from x and v.
  const double nx = o.x * m.xx + o.v * m.vx, nv = o.x * m.xv + o.v * m.vv;
  const double determinant = o.x * nv - o.v * nx;
  const double by_force = std::abs(value(o, m.from)) + std::abs(value(o, m.to));
  const double x_of_q = (std::abs(nv) + std::abs(o.v)) / std::abs(determinant);
  const double v_of_q = (std::abs(nx) + std::abs(o.x)) / std::abs(determinant);
  const double x_of_force = std::abs(o.v / determinant) * by_force;
  const double v_of_force = std::abs(o.x / determinant) * by_force;
  const auto bound = [&](double x, double v, double f, double slope) {
    return overshoot_bound(w.law, o, IntervalMotion(w.law, {x, v}, f, slope), w.step);
  };
  const double of_x = bound(1, 0, 0, 0), of_v = bound(0, 1, 0, 0);
  const double of_f = bound(0, 0, 1, 0);
  const double of_slope = hold ? 0 : bound(0, 0, 0, 2 / (w.step * static_cast<double>(substeps)));
  of_q = of_x * x_of_q + of_v * v_of_q;
  of_force = of_x * x_of_force + of_v * v_of_force + of_f + of_slope;
}

std::vector<double> largest_forces(const cromer_walk::Walk& walk) {
  std::vector<double> largest(walk.blocks());
  for (std::size_t block = 0; block < largest.size(); ++block) {
    const std::size_t from = block * walk.block, to = std::min(from + walk.block + 1, walk.samples - 1);
    for (std::size_t i = from; i <= to; ++i)
      largest[block] = std::max(largest[block], std::abs(walk.force[i]));
  }
  return largest;
}

void LawGroup::add(const LinearLaw<double>& law, const ResponseQuantity<double>& quantity, double step,
                   bool hold, double force) {
  const IntervalMap<double> map = interval_map(law, step, hold);
  const ResponseFilter<double> filter = response_filter(map, quantity);
  const FilterState<double> start = at_rest(map, force);
  const std::size_t lane = laws.size();
  filters.decay.of[lane] = filter.decay;
  filters.kappa.of[lane] = filter.kappa;
  filters.e0.of[lane] = filter.e0;
  filters.e2.of[lane] = filter.e2;
  filters.u.of[lane] = start.u;
  filters.d.of[lane] = start.d;
  laws.push_back({law, quantity, map, filter, step});
}

std::vector<double> walked_samples(const GroundMotion& ground) {
  std::vector<double> samples(ground.acceleration.begin(), ground.acceleration.end());
  if (ground.between == BetweenSamples::hold) samples.push_back(samples.back());
  return samples;
}

void for_each_group(std::span<const double> samples, const GroundMotion& ground,
                    std::span<const LinearLaw<double>> laws, std::span<const std::size_t> steps, Peaks peaks,
                    ResponseOf quantity, WalkGroup walk_group) {
  const bool hold = ground.between == BetweenSamples::hold;
  std::vector<std::size_t> order(laws.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return steps[a] < steps[b]; });
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    // The law with the finest steps sets those of all, except where the steps are part of the definition.
    end = std::min(begin + cromer_walk::lanes, order.size());
    if (peaks == Peaks::peer)
      while (steps[order[end - 1]] != steps[order[begin]]) --end;
    const std::size_t most = steps[order[end - 1]];
    const cromer_walk::Walk walk{.force = samples.data(),
                                 .samples = samples.size(),
                                 .substeps = most,
                                 .hold = hold,
                                 .every = peaks != Peaks::samples,
                                 .look_every = ground.refinement,
                                 .block = block_length(samples.size(), most)};
    LawGroup group;
    for (std::size_t i = begin; i < end; ++i) {
      const LinearLaw<double>& law = laws[order[i]];
      group.add(law, quantity_of(law, quantity), ground.spacing / static_cast<double>(most), hold,
                samples.front());
    }
    walk_group(group, walk, std::span(order).subspan(begin, end - begin));
  }
}

}  // namespace cromer::core
