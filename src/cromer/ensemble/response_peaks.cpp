#include "cromer/ensemble/response_peaks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "cromer/analysis/interval_peak.h"
#include "cromer/ensemble/dispatch.h"
#include "cromer/ensemble/filter_walk.h"

namespace cromer::core {
namespace {

/// One oscillator of a walk.
struct WalkedLaw {
  LinearLaw<double> law;
  ResponseQuantity<double> quantity;
  IntervalMap<double> map;
  ResponseFilter<double> filter;
  double step;  // [s]
};

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

double value(const ResponseQuantity<double>& quantity, const State<double>& y) {
  return quantity.x * y.x + quantity.v * y.v;
}

/// A bound on how far |q| may exceed both its end values in any interval, from bounds on |q| at its ends and
/// on the force in it.
struct BlockBound {
  double of_q, of_force;

  BlockBound(const WalkedLaw& w, std::size_t substeps, bool hold) {
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

 private:
  /// overshoot_bound, the state at the beginning being a linear function of both.
  void by_state(const WalkedLaw& w, std::size_t substeps, bool hold) {
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

/// Largest |force| in each block, the next sample included.
std::vector<double> largest_forces(const cromer_walk::Walk& walk) {
  std::vector<double> largest(walk.blocks());
  for (std::size_t block = 0; block < largest.size(); ++block) {
    const std::size_t from = block * walk.block, to = std::min(from + walk.block + 1, walk.samples - 1);
    for (std::size_t i = from; i <= to; ++i)
      largest[block] = std::max(largest[block], std::abs(walk.force[i]));
  }
  return largest;
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

double period_of(const LinearLaw<double>& law) { return 2 * std::numbers::pi / std::sqrt(law.stiffness); }

ResponseQuantity<double> quantity_of(const LinearLaw<double>& law, ResponseOf of) {
  // On the mirrored motion, driven by +a: the absolute acceleration is what spring and damper give it.
  switch (of) {
    case ResponseOf::displacement:
      return {1, 0};
    case ResponseOf::velocity:
      return {0, 1};
    default:
      return {law.stiffness, 2 * law.decay_rate};
  }
}

/// Blocks of about 32 steps, and not too many of them.
std::size_t block_length(std::size_t samples, std::size_t steps) {
  return std::max({std::size_t{1}, 32 / steps, samples / 8192});
}

/// Laws that are walked together, and the blocks that the walk writes.
struct LawGroup {
  cromer_walk::Filters filters{};
  std::vector<WalkedLaw> laws{};
  std::vector<cromer_walk::Block> blocks{};

  /// Its memory stays for the next laws.
  void clear() {
    filters = {};
    laws.clear();
  }
  void add(const LinearLaw<double>& law, const ResponseQuantity<double>& quantity, double step, bool hold,
           double force) {
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
  /// Lanes without a law rest: their filters are 0.
  void walk(const cromer_walk::Walk& walk, cromer_walk::Function function) {
    blocks.resize(walk.blocks());
    function(filters, walk, blocks.data());
  }
};

ResponsePeaks peaks_of(const LawGroup& group, std::size_t lane_of, const cromer_walk::Walk& walk,
                       std::span<const double> forces, const PeakSearch& search) {
  const WalkedLaw& law = group.laws[lane_of];
  const WalkedLane lane{group.blocks.data(), lane_of};
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
  std::vector<double> samples(ground.acceleration.begin(), ground.acceleration.end());
  const cromer_walk::Function walk_filters = search.walk ? search.walk : units_here().back().walk;
  const bool hold = ground.between == BetweenSamples::hold;
  if (hold) samples.push_back(samples.back());

  if (search.quantity == ResponseOf::velocity) {
    std::vector<ResponsePeaks> found;
    for (const LinearLaw<double>& law : laws) found.push_back(peaks_by_steps(samples, ground, law, search));
    return found;
  }

  std::vector<std::size_t> steps(laws.size()), order(laws.size());
  for (std::size_t i = 0; i < laws.size(); ++i) steps[i] = substeps(ground.spacing, period_of(laws[i]));
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return steps[a] < steps[b]; });

  std::vector<ResponsePeaks> found(laws.size());
  std::vector<double> forces;
  std::size_t block_of_forces = 0;
  LawGroup group;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    // The law with the finest steps sets those of all, except where the steps are part of the definition.
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
      group.add(law, quantity_of(law, search.quantity), ground.spacing / static_cast<double>(most), hold,
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
