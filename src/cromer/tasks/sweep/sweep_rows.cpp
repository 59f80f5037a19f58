#include "cromer/tasks/sweep/sweep_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "cromer/analysis/effective_oscillator.h"
#include "cromer/ensemble/group.h"
#include "cromer/methods/all.h"
#include "cromer/tasks/sweep/sweep_growth.h"

namespace cromer::core {
namespace {

constexpr std::uint64_t group_size = cromer_group::size;

/// What has not settled has no settled motion to tell of.
void write_measures(const SweepWork& work, const PointResult& found, double* to) {
  const PointResult result = has_numbers(found.status) ? found : PointResult{.status = found.status};
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

/// Where a linear law's motion settles, or why it does not.
template <class M>
PointResult in_closed_form(const M& method, const SweepPoint& at) {
  const Point& point = at.point;
  PointResult result;
  const Oscillator<double>& o = point.oscillator;
  std::optional<MethodSteadyState> steady;
  const double w = point.drive.frequency;
  if (at.loss_factor > 0) {
    const SteadyState answer = hysteretic_response(o, at.loss_factor, point.drive.amplitude, w);
    steady = MethodSteadyState{answer, answer.amplitude * w};
  } else if constexpr (M::info.order > 0 && M::info.error_order == 0) {
    steady = method_steady_state(method, linear_law(point), point.step);
  } else if (o.damping > 0 && o.stiffness > 0) {
    const SteadyState answer = frequency_response(o, point.drive.amplitude, w);
    steady = MethodSteadyState{answer, answer.amplitude * w};
  }
  if (!steady) {
    result.status = grows(method, point) ? PointStatus::unstable : PointStatus::not_settled;
    return result;
  }
  if (o.damping == 0 && at.loss_factor == 0) result.status = PointStatus::own_damping;
  const double x = steady->position.amplitude, v = steady->velocity;
  result.amplitude = result.peak = x;
  result.phase_lag = steady->position.phase_lag;
  result.mean = 0;
  result.rms = x / std::numbers::sqrt2;
  result.energy = (o.mass * v * v + o.stiffness * x * x) / 4;
  return result;
}

bool make_in_closed_form(const SweepWork& work, SweepPoints& points, std::uint64_t first, std::uint64_t count,
                         double* rows) {
  const std::size_t width = work.columns(), axes = work.axes.size();
  // The name is looked up once a stretch.
  return visit_method(work.method, points.settings_of(first), [&](const auto& method) {
    for (std::uint64_t i = 0; i < count; ++i) {
      double* row = rows + i * width;
      points.values_of(first + i, row);
      const auto at = points.at(row);
      write_measures(work, at ? in_closed_form(method, *at) : without_numbers(), row + axes);
    }
    return true;
  });
}

bool make_in_groups(const SweepWork& work, SweepPoints& points, std::uint64_t first, std::uint64_t count,
                    double* rows, const Watch& watch) {
  const MethodSettings settings = points.settings_of(first);
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
    const bool made =
        work.way == SweepWay::settled
            ? settle_group(work.unit, group, work.stepping(settings), work.settling, results, watch)
            : run_group(work.unit, group, work.stepping(settings), until, results, watch);
    if (!made) return false;
    for (std::size_t k = 0; k < results.size(); ++k) {
      name_status(work, settings, group[k], results[k]);
      write_measures(work, results[k], rows + place[k] * width + axes);
    }
  }
  return true;
}

/// Goes on from where a motion ended, the drive's angle with it.
void continue_from(const PointResult& ended, const Point& before, Point& next) {
  if (ended.status != PointStatus::not_settled && !has_numbers(ended.status)) return;
  next.start = ended.end;
  next.drive.phase =
      std::fmod(before.drive.frequency * ended.end_time + before.drive.phase, 2 * std::numbers::pi);
}

/// Chains side by side, each along the last axis.
bool make_chains(const SweepWork& work, SweepPoints& points, std::uint64_t first, std::uint64_t count,
                 double* rows, const Watch& watch) {
  const MethodSettings settings = points.settings_of(first);
  const std::size_t width = work.columns(), axes = work.axes.size();
  const std::uint64_t length = work.axes.back().grid.size(), chains = count / length;
  const bool rising = work.axes.back().grid[0] <= work.axes.back().grid[length - 1];
  const bool both = work.direction == SweepDirection::both;
  std::vector<Point> before(chains);
  std::vector<PointResult> ended(chains);
  for (std::uint64_t j = 0; j < length; ++j) {
    std::vector<Point> group(chains);
    std::vector<std::uint64_t> places(chains);
    for (std::uint64_t c = 0; c < chains; ++c) {
      double* row = rows + c * length * width;
      points.values_of(first + c * length, row);
      const bool up = both ? row[0] > 0 : work.direction == SweepDirection::up;
      places[c] = c * length + (up == rising ? j : length - 1 - j);
      row = rows + places[c] * width;
      points.values_of(first + places[c], row);
      const auto at = points.at(row);
      if (!at) return true;  // plan_sweep has looked at them: it cannot be
      group[c] = at->point;
      if (j > 0) continue_from(ended[c], before[c], group[c]);
    }
    if (!settle_group(work.unit, group, work.stepping(settings), work.settling, ended, watch)) return false;
    for (std::uint64_t c = 0; c < chains; ++c) {
      name_status(work, settings, group[c], ended[c]);
      write_measures(work, ended[c], rows + places[c] * width + axes);
    }
    before = group;
  }
  return true;
}

bool make_one_by_one(const SweepWork& work, SweepPoints& points, std::uint64_t first, std::uint64_t count,
                     double* rows, const Watch& watch) {
  const std::size_t width = work.columns(), axes = work.axes.size();
  for (std::uint64_t i = 0; i < count; ++i) {
    double* row = rows + i * width;
    points.values_of(first + i, row);
    const auto at = points.at(row);
    auto result = at ? run_point(work, *at, watch) : std::optional(without_numbers());
    if (!result) return false;
    if (at) name_status(work, at->settings, at->point, *result);
    write_measures(work, *result, row + axes);
  }
  return true;
}

/// Rows of equal settings.
bool make_stretch(const SweepWork& work, SweepPoints& points, std::uint64_t first, std::uint64_t count,
                  double* rows, const Watch& watch) {
  if (work.direction != SweepDirection::none) return make_chains(work, points, first, count, rows, watch);
  switch (work.way) {
    case SweepWay::closed_form:
      return make_in_closed_form(work, points, first, count, rows);
    case SweepWay::one_by_one:
      return make_one_by_one(work, points, first, count, rows, watch);
    case SweepWay::settled:
    case SweepWay::to_end:
      return make_in_groups(work, points, first, count, rows, watch);
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

std::uint64_t SweepWork::rows_of_equal_settings() const {
  std::uint64_t rows = 1;
  for (std::size_t i = axes.size(); i-- > 0 && !is_method_setting(axes[i].name);) rows *= axes[i].grid.size();
  return rows;
}

PointResult closed_form(const SweepWork& work, const SweepPoint& at) {
  return visit_method(work.method, at.settings,
                      [&](const auto& method) { return in_closed_form(method, at); });
}

std::optional<PointResult> settle_one(const SweepWork& work, const SweepPoint& at, const Watch& watch) {
  PointResult result;
  if (!settle_group(work.unit, std::span(&at.point, 1), work.stepping(at.settings), work.settling,
                    std::span(&result, 1), watch))
    return std::nullopt;
  name_status(work, at.settings, at.point, result);
  return result;
}

bool make_rows(const SweepWork& work, std::uint64_t first, std::uint64_t count, double* rows,
               const Watch& watch) {
  SweepPoints points(work.base, work.axes);
  const std::uint64_t same = work.rows_of_equal_settings(), end = first + count;
  const std::size_t width = work.columns();
  while (first < end) {
    const std::uint64_t stretch = std::min(end - first, same - first % same);
    if (!make_stretch(work, points, first, stretch, rows, watch)) return false;
    first += stretch;
    rows += stretch * width;
  }
  return true;
}

}  // namespace cromer::core
