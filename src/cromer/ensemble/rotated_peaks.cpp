#include "cromer/ensemble/rotated_peaks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace cromer::core {
namespace {

constexpr ResponseQuantity<double> displacement{1, 0};

struct Direction {
  double cosine, sine;
  double along(double first, double second) const { return cosine * first + sine * second; }
};

const std::array<Direction, directions>& all_directions() {
  static const auto table = [] {
    std::array<Direction, directions> result;
    for (int i = 0; i < directions; ++i) {
      const double angle = i * (std::numbers::pi / directions);
      result[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
    }
    return result;
  }();
  return table;
}

/// One oscillator shaken by both components: the force and the motion at the end of a step.
struct Step {
  double f1, f2;
  State<double> y1, y2;

  double radius() const { return std::hypot(y1.x, y2.x); }
};

/// A stretch of steps whose reach in each direction is wanted. Most steps lie well inside what a few far
/// ones span; only the others are looked at in every direction.
class Reach {
 public:
  Reach(const LinearLaw<double>& law, double step, bool hold, Peaks peaks)
      : law_(law), step_(step), hold_(hold), continuous_(peaks == Peaks::continuous) {}

  /// steps[0] is the last of the stretch before; `counts[i]` says whether the end of step i is looked at.
  void add(const std::vector<Step>& steps, const std::vector<char>& counts) {
    add_furthest(steps, counts);
    const double least = *std::min_element(reach_.begin(), reach_.end());
    for (std::size_t i = 1; i < steps.size(); ++i)
      if (counts[i] && steps[i].radius() > least) add_point(steps[i].y1.x, steps[i].y2.x);
    if (continuous_)
      for (std::size_t i = 0; i + 1 < steps.size(); ++i) add_between(steps[i], steps[i + 1], least);
  }

  void add_free_motion(const Step& last) {
    for (std::size_t i = 0; i < directions; ++i) {
      const Direction& d = all_directions()[i];
      Extremes range{-reach_[i], reach_[i]};
      include_free(law_, displacement, {d.along(last.y1.x, last.y2.x), d.along(last.y1.v, last.y2.v)}, range);
      reach_[i] = range.magnitude();
    }
  }

  RotatedPeaks peaks() const {
    auto sorted = reach_;
    std::sort(sorted.begin(), sorted.end());
    return {(sorted[directions / 2 - 1] + sorted[directions / 2]) / 2, sorted.back()};
  }

 private:
  void add_point(double x1, double x2) {
    for (std::size_t i = 0; i < directions; ++i)
      reach_[i] = std::max(reach_[i], std::abs(all_directions()[i].along(x1, x2)));
  }

  /// The points that lie furthest in eight directions.
  void add_furthest(const std::vector<Step>& steps, const std::vector<char>& counts) {
    for (std::size_t d = 0; d < directions; d += directions / 8) {
      const Direction direction = all_directions()[d];
      double most = -1;
      std::size_t furthest = 0;
      for (std::size_t i = 1; i < steps.size(); ++i) {
        const double x = std::abs(direction.along(steps[i].y1.x, steps[i].y2.x));
        if (!counts[i] || x <= most) continue;
        most = x;
        furthest = i;
      }
      if (most > 0) add_point(steps[furthest].y1.x, steps[furthest].y2.x);
    }
  }

  IntervalMotion motion(const State<double>& y, double f0, double f1) const {
    return IntervalMotion(law_, y, f0, hold_ ? 0 : (f1 - f0) / step_);
  }

  void add_between(const Step& from, const Step& to, double least) {
    const double over =
        std::hypot(overshoot_bound(law_, displacement, motion(from.y1, from.f1, to.f1), step_),
                   overshoot_bound(law_, displacement, motion(from.y2, from.f2, to.f2), step_));
    if (std::max(from.radius(), to.radius()) + over <= least) return;
    for (std::size_t i = 0; i < directions; ++i) {
      const Direction& d = all_directions()[i];
      const State<double> y{d.along(from.y1.x, from.y2.x), d.along(from.y1.v, from.y2.v)};
      const State<double> end{d.along(to.y1.x, to.y2.x), d.along(to.y1.v, to.y2.v)};
      if (std::max(std::abs(y.x), std::abs(end.x)) + over <= reach_[i]) continue;
      const IntervalMotion rotated = motion(y, d.along(from.f1, from.f2), d.along(to.f1, to.f2));
      const double bound = overshoot_bound(law_, displacement, rotated, step_);
      if (std::max(std::abs(y.x), std::abs(end.x)) + bound <= reach_[i]) continue;
      Extremes range{-reach_[i], reach_[i]};
      include_inside(law_, displacement, rotated, end, step_, range);
      reach_[i] = range.magnitude();
    }
  }

  const LinearLaw<double>& law_;
  double step_;
  bool hold_, continuous_;
  std::array<double, directions> reach_{};
};

/// Walks both components by the filter, so that long periods keep their digits.
class Walk {
 public:
  Walk(const LinearLaw<double>& law, double step, bool hold, double f1, double f2)
      : map_(interval_map(law, step, hold)),
        filter_(response_filter(map_, displacement)),
        motion_(filter_to_motion(map_)),
        first_(at_rest(map_, f1)),
        second_(at_rest(map_, f2)) {}

  Step to(double f1, double f2) {
    const Step end{f1, f2, motion_.next(first_, map_, f1), motion_.next(second_, map_, f2)};
    filter_.step(first_, f1);
    filter_.step(second_, f2);
    return end;
  }

 private:
  IntervalMap<double> map_;
  ResponseFilter<double> filter_;
  FilterToMotion<double> motion_;
  FilterState<double> first_, second_;
};

RotatedPeaks rotated_peaks(const std::vector<double>& first, const std::vector<double>& second,
                           const GroundMotion& ground, const LinearLaw<double>& law, Peaks peaks) {
  constexpr std::size_t stretch = 1 << 15;
  const double spacing = ground.spacing;
  const bool hold = ground.between == BetweenSamples::hold;
  const std::size_t parts = substeps(spacing, 2 * std::numbers::pi / std::sqrt(law.stiffness));
  const double step = spacing / static_cast<double>(parts);
  Walk walk(law, step, hold, first[0], second[0]);
  Reach reach(law, step, hold, peaks);
  std::vector<Step> steps{{first[0], second[0], {0, 0}, {0, 0}}};
  std::vector<char> counts{0};
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    const double part = hold ? 0 : 1 / static_cast<double>(parts);
    const double rise1 = part * (first[i + 1] - first[i]), rise2 = part * (second[i + 1] - second[i]);
    for (std::size_t j = 1; j <= parts; ++j) {
      const bool whole = j == parts;
      const double done = static_cast<double>(j);
      steps.push_back(walk.to(whole ? first[i + 1] : first[i] + done * rise1,
                              whole ? second[i + 1] : second[i] + done * rise2));
      counts.push_back(peaks != Peaks::samples || (whole && (i + 1) % ground.refinement == 0));
    }
    if (steps.size() < stretch && i + 2 < first.size()) continue;
    reach.add(steps, counts);
    steps = {steps.back()};
    counts = {0};
  }
  if (peaks == Peaks::continuous) reach.add_free_motion(steps.back());
  return reach.peaks();
}

}  // namespace

std::vector<RotatedPeaks> rotated_peaks(const GroundMotion& first, const GroundMotion& second,
                                        std::span<const LinearLaw<double>> laws, Peaks peaks) {
  std::vector<double> a(first.acceleration.begin(), first.acceleration.end());
  std::vector<double> b(second.acceleration.begin(), second.acceleration.end());
  if (first.between == BetweenSamples::hold) {
    a.push_back(a.back());
    b.push_back(b.back());
  }
  std::vector<RotatedPeaks> found;
  for (const auto& law : laws) found.push_back(rotated_peaks(a, b, first, law, peaks));
  return found;
}

}  // namespace cromer::core
