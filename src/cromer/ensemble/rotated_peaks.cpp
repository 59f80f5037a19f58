#include "cromer/ensemble/rotated_peaks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

#include "cromer/base/pi.h"
#include "cromer/ensemble/dispatch.h"
#include "cromer/ensemble/walked_laws.h"

namespace cromer::core {
namespace {

using cromer_walk::directions;
using cromer_walk::Reach;
using cromer_walk::sketched;

constexpr ResponseQuantity<double> displacement{1, 0};

Reach no_reach() {
  Reach reach{};
  for (std::size_t i = 0; i < Reach::size; ++i) {
    const double angle = static_cast<double>(i % directions) * (std::numbers::pi / directions);
    reach.cosine[i] = std::cos(angle);
    reach.sine[i] = std::sin(angle);
  }
  return reach;
}

/// Distances in the sketched directions.
using Sketch = std::array<double, sketched>;

/// The displacements that stay within a sketch fill a polygon. Its reach is interpolated between two sketched
/// directions: `before` and `after` are the weights of the one before and the one after.
struct SketchedDirections {
  Sketch cosine, sine;
  std::array<std::size_t, directions> sector;
  std::array<double, directions> before, after;

  SketchedDirections() {
    constexpr double wide = std::numbers::pi / sketched;
    for (std::size_t i = 0; i < directions; ++i) {
      sector[i] = i * sketched / directions;
      const double into =
          static_cast<double>(i) * (std::numbers::pi / directions) - static_cast<double>(sector[i]) * wide;
      before[i] = std::sin(wide - into) / std::sin(wide);
      after[i] = std::sin(into) / std::sin(wide);
    }
    for (std::size_t k = 0; k < sketched; ++k) {
      cosine[k] = std::cos(static_cast<double>(k) * wide);
      sine[k] = std::sin(static_cast<double>(k) * wide);
    }
  }
};

const SketchedDirections& sketched_directions() {
  static const SketchedDirections table;
  return table;
}

/// The largest multiples of the distances with which a polygon stays within the reach.
Sketch within(const Sketch& distances, const Reach& reach) {
  const SketchedDirections& sketch = sketched_directions();
  Sketch share;  // of each sector
  share.fill(1);
  for (std::size_t i = 0; i < directions; ++i) {
    const std::size_t k = sketch.sector[i];
    const double polygon = sketch.before[i] * distances[k] + sketch.after[i] * distances[(k + 1) % sketched];
    if (polygon > 0) share[k] = std::min(share[k], reach.magnitude[i] / polygon);
  }
  Sketch result;
  for (std::size_t k = 0; k < sketched; ++k)
    result[k] = distances[k] * std::min(share[(k + sketched - 1) % sketched], share[k]);
  return result;
}

/// FollowedSteps that are looked at closely; their memory serves block after block.
struct FollowedSteps {
  std::vector<double> x[2], v[2], f[2];
  std::vector<double> counted[2];  // displacements

  void clear() {
    for (auto* of : {x, v, f, counted})
      for (std::size_t c = 0; c < 2; ++c) of[c].clear();
  }
  void add(const State<double>& first, const State<double>& second, double f1, double f2) {
    x[0].push_back(first.x), v[0].push_back(first.v), f[0].push_back(f1);
    x[1].push_back(second.x), v[1].push_back(second.v), f[1].push_back(f2);
  }
};

/// Two components under all laws of a group, as a unit has walked them.
struct WalkOfTwo {
  const cromer_walk::Functions& unit;
  const cromer_walk::Walk& walk;
  std::span<const double> across;
  std::span<const double> largest_forces, largest_across;
  std::span<const cromer_walk::BlockOfTwo> blocks;
  bool continuous;
};

/// One oscillator of the group. Most blocks lie well inside what a few far ones span; only the others are
/// looked into.
class Orbit {
 public:
  Orbit(const WalkOfTwo& of, const WalkedLaw& law, std::size_t lane, FollowedSteps& steps, Reach& reach)
      : of_(of),
        law_(law),
        to_motion_(filter_to_motion(law.map)),
        bound_(law, of.walk.substeps, of.walk.hold),
        lane_(lane),
        steps_(steps),
        reach_(reach) {
    std::fill(std::begin(reach.magnitude), std::end(reach.magnitude), 0.0);
  }

  RotatedPeaks peaks() {
    const std::size_t blocks = of_.blocks.size();
    std::array<std::size_t, sketched> furthest{};
    Sketch most{};
    for (std::size_t block = 0; block < blocks; ++block) {
      const double* reach = reach_at_steps(block);
      for (std::size_t k = 0; k < sketched; ++k)
        if (reach[k] > most[k]) most[k] = reach[k], furthest[k] = block;
    }
    for (std::size_t k = 0; k < sketched; ++k) {
      const auto before = furthest.begin() + static_cast<std::ptrdiff_t>(k);
      distances_[k] = law_.filter.gain * most[k];
      if (std::find(furthest.begin(), before, furthest[k]) == before) look_into(furthest[k]);
    }
    Sketch inside = within(distances_, reach_);
    for (std::size_t block = 0; block < blocks; ++block) {
      if (!may_leave(inside, block) || std::find(furthest.begin(), furthest.end(), block) != furthest.end())
        continue;
      look_into(block);
      inside = within(distances_, reach_);
    }
    if (of_.continuous) add_free_motion();
    return {median(), *std::max_element(reach_.magnitude, reach_.magnitude + directions)};
  }

 private:
  const double* reach_at_steps(std::size_t block) const { return of_.blocks[block].reach[lane_]; }

  /// Whether the motion of a block may leave a polygon, that between its steps included.
  bool may_leave(const Sketch& inside, std::size_t block) const {
    const double gain = law_.filter.gain;
    const double* reach = reach_at_steps(block);
    bool may = false;
    if (!of_.continuous) {
      for (std::size_t k = 0; k < sketched; ++k) may |= gain * reach[k] > inside[k];
      return may;
    }
    const double* next = block + 1 < of_.blocks.size() ? reach_at_steps(block + 1) : reach;
    const SketchedDirections& sketch = sketched_directions();
    const double grown = gain * (1 + bound_.of_q);
    const double over1 = bound_.of_force * of_.largest_forces[block];
    const double over2 = bound_.of_force * of_.largest_across[block];
    for (std::size_t k = 0; k < sketched; ++k)
      may |=
          grown * std::max(reach[k], next[k]) + std::abs(sketch.cosine[k]) * over1 + sketch.sine[k] * over2 >
          inside[k];
    return may;
  }

  void look_into(std::size_t block) {
    follow(block);
    of_.unit.reach_of_points({steps_.counted[0].data(), steps_.counted[1].data(), steps_.counted[0].size()},
                             reach_);
    if (!of_.continuous) return;
    of_.unit.reach_of_path({.x = {steps_.x[0].data(), steps_.x[1].data()},
                            .v = {steps_.v[0].data(), steps_.v[1].data()},
                            .f = {steps_.f[0].data(), steps_.f[1].data()},
                            .count = steps_.x[0].size(),
                            .hold = of_.walk.hold,
                            .h = law_.step,
                            .decay_rate = law_.law.decay_rate,
                            .stiffness = law_.law.stiffness},
                           reach_);
  }

  /// The steps of a block, for continuous peaks to the first one of the next block: its own begin there. By
  /// the filter, so that long periods keep their digits.
  void follow(std::size_t block) {
    const cromer_walk::Walk& walk = of_.walk;
    const cromer_walk::BlockOfTwo& begin = of_.blocks[block];
    FilterState<double> first{begin.u[0].of[lane_], begin.d[0].of[lane_]};
    FilterState<double> second{begin.u[1].of[lane_], begin.d[1].of[lane_]};
    steps_.clear();
    if (block == 0) steps_.add({0, 0}, {0, 0}, walk.force[0], of_.across[0]);
    const std::size_t end = std::min((block + 1) * walk.block, walk.samples - 1);
    const double part = walk.hold ? 0 : 1 / static_cast<double>(walk.substeps);
    for (std::size_t i = block * walk.block; i < walk.samples - 1; ++i) {
      const double rise1 = part * (walk.force[i + 1] - walk.force[i]);
      const double rise2 = part * (of_.across[i + 1] - of_.across[i]);
      for (std::size_t j = 1; j <= walk.substeps; ++j) {
        const bool whole = j == walk.substeps;
        const auto done = static_cast<double>(j);
        const double f1 = whole ? walk.force[i + 1] : walk.force[i] + done * rise1;
        const double f2 = whole ? of_.across[i + 1] : of_.across[i] + done * rise2;
        const State<double> y1 = to_motion_.next(first, law_.map, f1),
                            y2 = to_motion_.next(second, law_.map, f2);
        steps_.add(y1, y2, f1, f2);
        if (i == end) return;
        if (walk.every || (whole && (i + 1) % walk.look_every == 0)) {
          steps_.counted[0].push_back(y1.x);
          steps_.counted[1].push_back(y2.x);
        }
        law_.filter.step(first, f1);
        law_.filter.step(second, f2);
      }
      if (i + 1 == end && !of_.continuous) return;
    }
  }

  void add_free_motion() {
    follow(of_.blocks.size() - 1);
    const State<double> first{steps_.x[0].back(), steps_.v[0].back()};
    const State<double> second{steps_.x[1].back(), steps_.v[1].back()};
    for (std::size_t i = 0; i < directions; ++i) {
      const auto along = [&](double a, double b) { return reach_.cosine[i] * a + reach_.sine[i] * b; };
      const State<double> y{along(first.x, second.x), along(first.v, second.v)};
      // The energy of a free motion only falls: most cannot swing as far again.
      const double reach = reach_.magnitude[i];
      if (y.x * y.x + y.v * y.v / law_.law.stiffness <= reach * reach) continue;
      Extremes range{-reach, reach};
      include_free(law_.law, displacement, y, range);
      reach_.magnitude[i] = range.magnitude();
    }
  }

  double median() const {
    std::array<double, directions> sorted;
    std::copy_n(reach_.magnitude, directions, sorted.begin());
    const auto middle = sorted.begin() + directions / 2;
    std::nth_element(sorted.begin(), middle, sorted.end());
    return (*std::max_element(sorted.begin(), middle) + *middle) / 2;
  }

  const WalkOfTwo& of_;
  const WalkedLaw& law_;
  FilterToMotion<double> to_motion_;
  BlockBound bound_;
  std::size_t lane_;
  FollowedSteps& steps_;
  Reach& reach_;
  Sketch distances_{};
};

/// The law's parts of the motion die and swing with these rates at most [1/s].
double fastest_rate(const LinearLaw<double>& law) {
  const double b = law.decay_rate, discriminant = b * b - law.stiffness;
  return discriminant > 0 ? b + std::sqrt(discriminant) : std::sqrt(law.stiffness);
}

}  // namespace

std::vector<RotatedPeaks> rotated_peaks(const GroundMotion& first, const GroundMotion& second,
                                        std::span<const LinearLaw<double>> laws, Peaks peaks,
                                        const cromer_walk::Functions& unit_asked_for) {
  const cromer_walk::Functions unit = unit_asked_for.walk_two ? unit_asked_for : units_here().back().walk;
  const std::vector<double> along = walked_samples(first), across = walked_samples(second);
  const bool continuous = peaks == Peaks::continuous;
  std::vector<std::size_t> substeps_of(laws.size());
  for (std::size_t i = 0; i < laws.size(); ++i)
    substeps_of[i] =
        substeps(first.spacing, continuous ? two_pi / fastest_rate(laws[i]) : period_of(laws[i]));

  std::vector<RotatedPeaks> found(laws.size());
  std::vector<cromer_walk::BlockOfTwo> blocks;
  std::vector<double> forces, forces_across;
  FollowedSteps steps;
  Reach reach = no_reach();
  std::size_t block_of_forces = 0;
  for_each_group(
      along, first, laws, substeps_of, peaks, ResponseOf::displacement,
      [&](const LawGroup& group, const cromer_walk::Walk& walk, std::span<const std::size_t> places) {
        cromer_walk::Filters across_filters{};
        for (std::size_t i = 0; i < places.size(); ++i) {
          const FilterState<double> start = at_rest(group.laws[i].map, across.front());
          across_filters.u.of[i] = start.u;
          across_filters.d.of[i] = start.d;
        }
        blocks.resize(walk.blocks());
        unit.walk_two(group.filters, across_filters, walk, across.data(), blocks.data());
        if (block_of_forces != walk.block) {
          cromer_walk::Walk other = walk;
          other.force = across.data();
          forces = largest_forces(walk);
          forces_across = largest_forces(other);
          block_of_forces = walk.block;
        }
        const WalkOfTwo both{unit, walk, across, forces, forces_across, blocks, continuous};
        for (std::size_t i = 0; i < places.size(); ++i)
          found[places[i]] = Orbit(both, group.laws[i], i, steps, reach).peaks();
      });
  return found;
}

}  // namespace cromer::core
