#include "cromer/study/task/sweep_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "cromer/analysis/method_steady_state.h"
#include "cromer/ensemble/group.h"
#include "cromer/methods/all.h"

namespace cromer {
namespace {

constexpr std::uint64_t group_size = cromer_group::size;

/// What has not settled has no settled motion to tell of.
void write_measures(const SweepWork& work, const PointResult& found, double* to) {
  const bool unsettled = found.status == PointStatus::not_settled;
  const PointResult result = unsettled ? PointResult{.status = found.status} : found;
  for (const Measure* measure : work.measures) {
    measure->write(result, to);
    to += measure->columns.size();
  }
  *to = static_cast<double>(result.status);
}

/// A law that cannot be stepped (no period to choose a step by) has no numbers.
PointResult without_numbers() {
  PointResult result;
  result.status = PointStatus::not_finite;
  return result;
}

LinearLaw<double> linear_law(const Point& point) {
  const Oscillator<double>& o = point.oscillator;
  return {.decay_rate = o.damping / (2 * o.mass),
          .stiffness = o.stiffness / o.mass,
          .drive_amplitude = point.drive.amplitude / o.mass,
          .drive_frequency = point.drive.frequency,
          .drive_phase = point.drive.phase};
}

PointResult in_closed_form(const Point& point, const std::optional<MethodSteadyState>& steady) {
  PointResult result;
  result.status = steady ? PointStatus::done : PointStatus::not_settled;
  if (!steady) return result;
  const double x = steady->position.amplitude, v = steady->velocity;
  result.amplitude = result.peak = x;
  result.phase_lag = steady->position.phase_lag;
  result.mean = 0;
  result.energy = (point.oscillator.mass * v * v + point.oscillator.stiffness * x * x) / 4;
  return result;
}

template <class M>
std::optional<MethodSteadyState> steady_state_by(const M& method, const SweepPoint& at) {
  const Point& point = at.point;
  if (at.loss_factor > 0) {
    const double w = point.drive.frequency;
    const SteadyState steady =
        hysteretic_response(point.oscillator, at.loss_factor, point.drive.amplitude, w);
    return MethodSteadyState{steady, steady.amplitude * w};
  }
  if constexpr (M::info.order > 0 && M::info.error_order == 0) {
    return method_steady_state(method, linear_law(point), point.step);
  } else {
    const Oscillator<double>& o = point.oscillator;
    const double w = point.drive.frequency;
    const SteadyState steady = frequency_response(o, point.drive.amplitude, w);
    if (!(o.damping > 0)) return std::nullopt;
    return MethodSteadyState{steady, steady.amplitude * w};
  }
}

bool make_in_closed_form(const SweepWork& work, std::uint64_t first, std::uint64_t count, double* rows) {
  SweepPoints points(work.base, work.axes);
  const std::size_t width = work.columns(), axes = work.axes.size();
  // The name is looked up once a chunk.
  return visit_method(work.method, work.settings, [&](const auto& method) {
    for (std::uint64_t i = 0; i < count; ++i) {
      double* row = rows + i * width;
      points.values_of(first + i, row);
      const auto at = points.at(row);
      write_measures(work, at ? in_closed_form(at->point, steady_state_by(method, *at)) : without_numbers(),
                     row + axes);
    }
    return true;
  });
}

bool make_in_groups(const SweepWork& work, std::uint64_t first, std::uint64_t count, double* rows,
                    const Watch& watch) {
  SweepPoints points(work.base, work.axes);
  const std::size_t width = work.columns(), axes = work.axes.size();
  for (std::uint64_t begin = 0; begin < count; begin += group_size) {
    const std::uint64_t size = std::min(group_size, count - begin);
    std::vector<Point> group;
    std::vector<double> until;
    std::vector<std::uint64_t> place;
    for (std::uint64_t i = begin; i < begin + size; ++i) {
      double* row = rows + i * width;
      points.values_of(first + i, row);
      if (const auto at = points.at(row)) {
        group.push_back(at->point);
        until.push_back(at->until);
        place.push_back(i);
      } else {
        write_measures(work, without_numbers(), row + axes);
      }
    }
    if (group.empty()) continue;
    std::vector<PointResult> results(group.size());
    const bool made = work.way == SweepWay::settled
                          ? settle_group(work.unit, group, work.stepping(), work.settling, results, watch)
                          : run_group(work.unit, group, work.stepping(), until, results, watch);
    if (!made) return false;
    for (std::size_t k = 0; k < results.size(); ++k)
      write_measures(work, results[k], rows + place[k] * width + axes);
  }
  return true;
}

/// Goes on from where a motion ended, the drive's angle with it.
void continue_from(const PointResult& ended, const Point& before, Point& next) {
  if (ended.status == PointStatus::not_finite || ended.status == PointStatus::no_convergence) return;
  next.start = ended.end;
  next.drive.phase =
      std::fmod(before.drive.frequency * ended.end_time + before.drive.phase, 2 * std::numbers::pi);
}

/// Chains side by side, each along the last axis.
bool make_chains(const SweepWork& work, std::uint64_t first, std::uint64_t count, double* rows,
                 const Watch& watch) {
  SweepPoints points(work.base, work.axes);
  const std::size_t width = work.columns(), axes = work.axes.size();
  const std::uint64_t length = work.axes.back().grid.size(), chains = count / length;
  const bool rising = work.axes.back().grid[0] <= work.axes.back().grid[length - 1];
  const bool forward = rising == (work.direction == SweepDirection::up);
  std::vector<Point> before(chains);
  std::vector<PointResult> ended(chains);
  for (std::uint64_t j = 0; j < length; ++j) {
    const std::uint64_t along = forward ? j : length - 1 - j;
    std::vector<Point> group(chains);
    for (std::uint64_t c = 0; c < chains; ++c) {
      double* row = rows + (c * length + along) * width;
      points.values_of(first + c * length + along, row);
      const auto at = points.at(row);
      if (!at) return true;  // plan_sweep has looked at them: it cannot be
      group[c] = at->point;
      if (j > 0) continue_from(ended[c], before[c], group[c]);
    }
    if (!settle_group(work.unit, group, work.stepping(), work.settling, ended, watch)) return false;
    for (std::uint64_t c = 0; c < chains; ++c)
      write_measures(work, ended[c], rows + (c * length + along) * width + axes);
    before = group;
  }
  return true;
}

bool make_one_by_one(const SweepWork& work, std::uint64_t first, std::uint64_t count, double* rows,
                     const Watch& watch) {
  SweepPoints points(work.base, work.axes);
  const std::size_t width = work.columns(), axes = work.axes.size();
  for (std::uint64_t i = 0; i < count; ++i) {
    double* row = rows + i * width;
    points.values_of(first + i, row);
    const auto at = points.at(row);
    const auto result = at ? run_point(work, *at, watch) : std::optional(without_numbers());
    if (!result) return false;
    write_measures(work, *result, row + axes);
  }
  return true;
}

}  // namespace

std::size_t SweepWork::columns() const {
  std::size_t columns = axes.size() + 1;
  for (const Measure* measure : measures) columns += measure->columns.size();
  return columns;
}

std::uint64_t SweepWork::rows_per_chunk() const {
  std::uint64_t few = 4;  // run by run
  if (direction != SweepDirection::none)
    few = axes.back().grid.size() * group_size;
  else if (way == SweepWay::closed_form)
    few = 8192;
  else if (way != SweepWay::one_by_one)
    few = 4 * group_size;
  // To hand out a chunk costs 20 us in the worst case: all of them some seconds, however long the sweep.
  constexpr double most_chunks = 262144;
  double rows = 1;
  for (const SweepAxis& axis : axes) rows *= static_cast<double>(axis.grid.size());
  const double times = std::ceil(rows / static_cast<double>(few) / most_chunks);
  return few * static_cast<std::uint64_t>(std::max(1.0, times));
}

PointResult closed_form(const SweepWork& work, const Point& point) {
  return visit_method(work.method, work.settings, [&](const auto& method) {
    return in_closed_form(point, steady_state_by(method, SweepPoint{point, 0, 0}));
  });
}

std::optional<PointResult> settle_one(const SweepWork& work, const Point& point, const Watch& watch) {
  PointResult result;
  if (!settle_group(work.unit, std::span(&point, 1), work.stepping(), work.settling, std::span(&result, 1),
                    watch))
    return std::nullopt;
  return result;
}

bool make_rows(const SweepWork& work, std::uint64_t first, std::uint64_t count, double* rows,
               const Watch& watch) {
  if (work.direction != SweepDirection::none) return make_chains(work, first, count, rows, watch);
  switch (work.way) {
    case SweepWay::closed_form:
      return make_in_closed_form(work, first, count, rows);
    case SweepWay::one_by_one:
      return make_one_by_one(work, first, count, rows, watch);
    case SweepWay::settled:
    case SweepWay::to_end:
      return make_in_groups(work, first, count, rows, watch);
  }
  return true;
}

}  // namespace cromer
