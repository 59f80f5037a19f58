#include "cromer/ensemble/response_peaks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "cromer/analysis/interval_peak.h"
#include "cromer/ensemble/dispatch.h"
#include "cromer/ensemble/filter_walk.h"
#include "cromer/ensemble/walked_laws.h"

namespace cromer::core {
namespace {

/// Its lane in the blocks that the walk wrote.
struct WalkedLane {
  const cromer_walk::Block* blocks;
  std::size_t lane;

  FilterState<double> state(std::size_t i) const { return {blocks[i].u.of[lane], blocks[i].d.of[lane]}; }
  double low(std::size_t i) const { return blocks[i].low.of[lane]; }
  double high(std::size_t i) const { return blocks[i].high.of[lane]; }
};

/// The steps of one block from its beginning, with the state of the motion.
class BlockSteps {
 public:
  BlockSteps(const cromer_walk::Walk& walk, const WalkedLaw& law, const WalkedLane& lane, std::size_t block)
      : walk_(walk), law_(law), to_motion_(filter_to_motion(law.map)), interval_(block * walk.block) {
    state_ = lane.state(block);
    if (block == 0)
      y_ = {0, 0};
    else
      advance_first();
  }

  const State<double>& state() const { return y_; }
  /// The force at the present step.
  double force() const { return at(part_); }
  /// Its slope in an interval.
  double slope(std::size_t i) const {
    if (walk_.hold) return 0;
    return (walk_.force[i + 1] - walk_.force[i]) / (law_.step * static_cast<double>(walk_.substeps));
  }
  std::size_t interval() const { return interval_; }
  bool at_end() const { return interval_ + 1 >= walk_.samples; }

  void advance() {
    const double f0 = force(), f1 = walk_.hold ? f0 : at(part_ + 1);
    y_ = law_.map(y_, f0, f1);
    count();
  }

 private:
  double from() const { return walk_.force[interval_]; }
  double to() const { return walk_.force[interval_ + 1]; }
  double at(std::size_t part) const {
    if (walk_.hold || part == 0) return from();
    if (part == walk_.substeps) return to();
    return from() + static_cast<double>(part) * ((to() - from()) / static_cast<double>(walk_.substeps));
  }
  void advance_first() {
    y_ = to_motion_.next(state_, law_.map, walk_.hold ? from() : at(part_ + 1));
    count();
  }
  void count() {
    if (++part_ < walk_.substeps) return;
    part_ = 0;
    ++interval_;
  }

  const cromer_walk::Walk& walk_;
  const WalkedLaw& law_;
  FilterToMotion<double> to_motion_;
  FilterState<double> state_{};
  State<double> y_{};
  std::size_t interval_, part_ = 0;
};

struct Refinement {
  const cromer_walk::Walk& walk;
  std::span<const double> largest_forces;
  const WalkedLaw& law;
  const WalkedLane& lane;
  bool largest_alone;
  Extremes best;
  BlockBound bound;

  bool beats(double low, double high, double slack) const {
    return high + slack > best.high || low - slack < best.low;
  }
  void settle() {
    if (!largest_alone) return;
    const double most = best.magnitude();
    best = {-most, most};
  }

  /// How far the quantity may rise between two steps of a block.
  double slack(std::size_t block) const {
    const double reach = std::max(-low(block), high(block));
    return bound.of_q * reach + bound.of_force * largest_forces[block];
  }
  bool may_hold(std::size_t block) const { return beats(low(block), high(block), slack(block)); }

  void look_into(std::size_t block) {
    const std::size_t last = (block + 1) * walk.block;
    const double at_most = slack(block);
    BlockSteps steps(walk, law, lane, block);
    double before = value(law.quantity, steps.state());
    // To the first step of the next block: its own begin there.
    for (bool more = true; more && !steps.at_end();) {
      more = steps.interval() < last;
      const State<double> y = steps.state();
      const double force = steps.force();
      const std::size_t interval = steps.interval();
      steps.advance();
      const double after = value(law.quantity, steps.state());
      const double least = std::min(before, after), greatest = std::max(before, after);
      before = after;
      if (beats(least, greatest, at_most))
        include_between(IntervalMotion(law.law, y, force, steps.slope(interval)), steps.state(), least,
                        greatest);
    }
  }

  void include_between(const IntervalMotion& motion, const State<double>& end, double least,
                       double greatest) {
    if (!beats(least, greatest, overshoot_bound(law.law, law.quantity, motion, law.step))) return;
    include_inside(law.law, law.quantity, motion, end, law.step, best);
    settle();
  }

 private:
  /// Of a block and the first step beyond it; 0 included.
  double low(std::size_t block) const {
    double least = std::min(0.0, lane.low(block));
    if (block + 1 < walk.blocks()) least = std::min(least, lane.low(block + 1));
    return law.filter.gain * least;
  }
  double high(std::size_t block) const {
    double most = std::max(0.0, lane.high(block));
    if (block + 1 < walk.blocks()) most = std::max(most, lane.high(block + 1));
    return law.filter.gain * most;
  }
};

/// The extremes at the steps of the walk, and 0 for the beginning.
Extremes range_of(const cromer_walk::Walk& walk, const WalkedLaw& law, const WalkedLane& lane) {
  Extremes range{0, 0};
  for (std::size_t i = 0, n = walk.blocks(); i < n; ++i) {
    range.low = std::min(range.low, lane.low(i));
    range.high = std::max(range.high, lane.high(i));
  }
  return {law.filter.gain * range.low, law.filter.gain * range.high};
}

/// The extremes between the steps too. Nothing is missed: a block is passed over only where a bound on how
/// far the quantity may rise between two steps allows it.
Extremes refined(const cromer_walk::Walk& walk, std::span<const double> largest_forces, const WalkedLaw& law,
                 const WalkedLane& lane, bool largest_alone) {
  const std::size_t blocks = walk.blocks();
  std::vector<double> reach(blocks + 1);
  Extremes range{0, 0};
  for (std::size_t i = 0; i < blocks; ++i) {
    const double low = law.filter.gain * lane.low(i), high = law.filter.gain * lane.high(i);
    range.low = std::min(range.low, low);
    range.high = std::max(range.high, high);
    reach[i] = std::max(-low, high);
  }
  Refinement refinement{
      walk, largest_forces, law, lane, largest_alone, range, BlockBound(law, walk.substeps, walk.hold)};
  refinement.settle();
  // First where the steps reached furthest: it leaves little for the others to beat.
  const auto furthest =
      static_cast<std::size_t>(std::max_element(reach.begin(), reach.end() - 1) - reach.begin());
  refinement.look_into(furthest);
  const double grown = 1 + refinement.bound.of_q;
  for (std::size_t i = 0; i < blocks; ++i) {
    const double most =
        std::max(reach[i], reach[i + 1]) * grown + refinement.bound.of_force * largest_forces[i];
    const bool may = most > std::min(refinement.best.high, -refinement.best.low);
    if (may && i != furthest && refinement.may_hold(i)) refinement.look_into(i);
  }
  return refinement.best;
}

/// The motion at the last sample (the end of its hold).
State<double> last_state(const cromer_walk::Walk& walk, const WalkedLaw& law, const WalkedLane& lane) {
  BlockSteps steps(walk, law, lane, walk.blocks() - 1);
  while (!steps.at_end()) steps.advance();
  return steps.state();
}

ResponsePeaks peaks_of(const WalkedLaw& law, const WalkedLane& lane, const cromer_walk::Walk& walk,
                       std::span<const double> forces, const PeakSearch& search) {
  ResponsePeaks found{search.peaks == Peaks::continuous
                          ? refined(walk, forces, law, lane, search.largest_alone)
                          : range_of(walk, law, lane),
                      {0, 0}};
  if (!search.after_the_end) return found;
  const State<double> last = last_state(walk, law, lane);
  const double q = law.quantity.x * last.x + law.quantity.v * last.v;
  found.after = {q, q};
  // The energy of a free motion only falls: it may be clear that it cannot swing as far again.
  const double farthest = std::hypot(last.x, last.v / std::sqrt(law.law.stiffness));
  const bool no_farther = search.largest_alone && law.quantity.v == 0 &&
                          std::abs(law.quantity.x) * farthest <= found.during.magnitude();
  if (!no_farther) include_free(law.law, law.quantity, last, found.after);
  return found;
}

/// The extremes of a quantity without the position, which has no filter: step by step.
ResponsePeaks peaks_by_steps(const std::vector<double>& samples, const GroundMotion& ground,
                             const LinearLaw<double>& law, const PeakSearch& search) {
  const bool hold = ground.between == BetweenSamples::hold;
  const std::size_t parts = substeps(ground.spacing, period_of(law));
  const double step = ground.spacing / static_cast<double>(parts);
  const ResponseQuantity<double> quantity = quantity_of(law, search.quantity);
  const IntervalMap<double> map = interval_map(law, step, hold);
  const ResponseFilter<double> filter = response_filter(map, ResponseQuantity<double>{1, 0});
  const FilterToMotion<double> to_motion = filter_to_motion(map);
  FilterState<double> state = at_rest(map, samples.front());
  State<double> y{0, 0};
  ResponsePeaks found{{0, 0}, {0, 0}};
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const double slope = hold ? 0 : (samples[i + 1] - samples[i]) / ground.spacing;
    for (std::size_t part = 1; part <= parts; ++part) {
      const double before = samples[i] + slope * step * static_cast<double>(part - 1);
      const bool whole = part == parts;
      const double force = whole ? samples[i + 1] : samples[i] + slope * step * static_cast<double>(part);
      const State<double> start = y;
      y = to_motion.next(state, map, force);
      filter.step(state, force);
      const double from = value(quantity, start), to = value(quantity, y);
      if (search.peaks != Peaks::samples || (whole && (i + 1) % ground.refinement == 0))
        found.during.include(to);
      if (search.peaks != Peaks::continuous) continue;
      const IntervalMotion motion(law, start, before, slope);
      const double over = overshoot_bound(law, quantity, motion, step);
      if (std::max(from, to) + over > found.during.high || std::min(from, to) - over < found.during.low)
        include_inside(law, quantity, motion, y, step, found.during);
    }
  }
  if (!search.after_the_end) return found;
  const double last = value(quantity, y);
  found.after = {last, last};
  include_free(law, quantity, y, found.after);
  return found;
}

}  // namespace

std::size_t substeps(double spacing, double period) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(10 * spacing / period - 1e-9)));
}

std::vector<ResponsePeaks> response_peaks(const GroundMotion& ground, std::span<const LinearLaw<double>> laws,
                                          const PeakSearch& search) {
  const std::vector<double> samples = walked_samples(ground);
  const cromer_walk::Functions unit = search.unit.walk ? search.unit : units_here().back().walk;

  if (search.quantity == ResponseOf::velocity) {
    std::vector<ResponsePeaks> found;
    for (const LinearLaw<double>& law : laws) found.push_back(peaks_by_steps(samples, ground, law, search));
    return found;
  }

  std::vector<std::size_t> steps(laws.size());
  for (std::size_t i = 0; i < laws.size(); ++i) steps[i] = substeps(ground.spacing, period_of(laws[i]));
  std::vector<ResponsePeaks> found(laws.size());
  std::vector<double> forces;
  std::vector<cromer_walk::Block> blocks;
  std::size_t block_of_forces = 0;
  for_each_group(
      samples, ground, laws, steps, search.peaks, search.quantity,
      [&](const LawGroup& group, const cromer_walk::Walk& walk, std::span<const std::size_t> places) {
        blocks.resize(walk.blocks());
        unit.walk(group.filters, walk, blocks.data());
        if (block_of_forces != walk.block) forces = largest_forces(walk);
        block_of_forces = walk.block;
        for (std::size_t i = 0; i < places.size(); ++i)
          found[places[i]] = peaks_of(group.laws[i], {blocks.data(), i}, walk, forces, search);
      });
  return found;
}

}  // namespace cromer::core
