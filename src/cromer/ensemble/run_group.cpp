#include "cromer/ensemble/run_group.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>

#include "cromer/analysis/energy.h"
#include "cromer/ensemble/fill_group.h"
#include "cromer/run/course.h"

namespace cromer::core {
namespace {

using cromer_group::Group;

constexpr long long steps_between_looks = 1 << 16;  // at the interrupt

/// The shorter step that ends some runs, for all members: a run of its own, whose drive goes on where it was.
std::unique_ptr<Group> with_last_step(const Group& group, const KernelUnit& unit, const Stepping& stepping,
                                      const std::array<double, cromer_group::size>& last) {
  auto ended = std::make_unique<Group>(group);
  for (int i = 0; i < cromer_group::size; ++i) {
    ended->drive_phase.of[i] += group.drive_frequency.of[i] * (group.steps * group.step.of[i]);
    ended->step.of[i] =
        last[static_cast<std::size_t>(i)] > 0 ? last[static_cast<std::size_t>(i)] : group.step.of[i];
  }
  ended->steps = 0;
  unit.advance(*ended, order_of(stepping, 1));
  return ended;
}

PointResult result_of(const Group& group, int i, const Point& point, double end) {
  PointResult result;
  result.status = status_of(group, i);
  result.end_time = end;
  if (result.status != PointStatus::done) return result;
  result.peak = group.peak.of[i];
  result.end = {group.x.of[i], group.v.of[i]};
  result.energy = energy(point.oscillator, result.end);
  return result;
}

}  // namespace

bool run_group(const KernelUnit& unit, std::span<const Point> points, const Stepping& stepping,
               std::span<const double> until, std::span<PointResult> results, const Watch& watch) {
  assert(points.size() == results.size() && points.size() == until.size());
  auto group = std::make_unique<Group>();
  fill_group(points, *group);
  for (std::size_t k = 0; k < points.size(); ++k) group->peak.of[k] = std::abs(points[k].start.x);

  std::array<long long, cromer_group::size> whole{};
  std::array<double, cromer_group::size> last{};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Steps steps = count_steps({0, until[k]}, points[k].step);
    whole[k] = steps.whole;
    last[k] = steps.last;
  }
  const auto members = static_cast<std::ptrdiff_t>(points.size());
  const long long most = *std::max_element(whole.begin(), whole.begin() + members);
  for (long long taken = 0;;) {
    // To where the next one ends.
    long long next = most;
    for (std::size_t k = 0; k < points.size(); ++k)
      if (whole[k] >= taken) next = std::min(next, whole[k]);
    while (taken < next) {
      if (watch.interrupted()) return false;
      const long long steps = std::min(next - taken, steps_between_looks);
      unit.advance(*group, order_of(stepping, steps));
      taken += steps;
    }
    std::unique_ptr<Group> ended;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (whole[k] != taken) continue;
      const int i = static_cast<int>(k);
      if (last[k] > 0 && !ended) ended = with_last_step(*group, unit, stepping, last);
      results[k] = result_of(last[k] > 0 ? *ended : *group, i, points[k], until[k]);
    }
    if (taken == most) return true;
    // Those that have ended are not looked at any more.
    for (std::size_t k = 0; k < points.size(); ++k)
      if (whole[k] == taken) whole[k] = -1;
  }
}

}  // namespace cromer::core
