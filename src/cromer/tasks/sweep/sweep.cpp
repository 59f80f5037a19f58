#include "cromer/tasks/sweep/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "cromer/base/grid.h"
#include "cromer/methods/all.h"
#include "cromer/tasks/sweep/sweep_rows.h"

namespace cromer::core {
namespace {

constexpr std::size_t checked_points = 8;

/// For a point that has no numbers in closed form, or none when stepped.
Notice why_left_out(PointStatus known, PointStatus stepped) {
  if (known == PointStatus::unstable) return Notice{"grows_without_end"};
  if (!has_numbers(known)) return Notice{"undamped_never_settles"};
  return Notice{stepped == PointStatus::not_settled ? "stepped_not_settled" : "stepped_runs_away"};
}

}  // namespace

std::optional<SweepCheck> check_closed_form(const SweepPlan& plan, const Watch& watch) {
  const SweepWork& work = *plan.work;
  if (work.way != SweepWay::closed_form || !(find_method(work.method)->order > 0)) return std::nullopt;
  SweepCheck check;
  SweepPoints points(work.base, work.axes);
  std::vector<double> values(work.axes.size());
  const std::uint64_t count = std::min<std::uint64_t>(checked_points, plan.rows.rows);
  for (std::uint64_t k = 0; k < count; ++k) {
    const std::uint64_t row = k * (plan.rows.rows - 1) / std::max<std::uint64_t>(1, count - 1);
    points.values_of(row, values.data());
    const auto at = points.at(values.data());
    if (!at) continue;
    const PointResult known = closed_form(work, *at);
    const auto stepped = settle_one(work, *at, watch);
    if (!stepped) return std::nullopt;
    if (!has_numbers(known.status) || stepped->status != PointStatus::done) {
      if (check.left_out++ > 0) continue;
      check.first_left_out = row;
      check.why = why_left_out(known.status, stepped->status);
      continue;
    }
    ++check.points;
    check.difference = std::max(check.difference, std::abs(stepped->amplitude / known.amplitude - 1));
  }
  return check;
}

Result<SweepResult> sweep(const SweepOptions& options, const Watch& watch) {
  auto plan = plan_sweep(options);
  if (!plan) return plan.error();
  const auto make = [](const ChunkedRows& work, const std::vector<std::uint64_t>& chunks, int threads,
                       const ChunkSink& sink,
                       const Watch& watching) { return make_chunks(work, chunks, threads, sink, watching); };
  return sweep(*std::move(plan), options, make, watch);
}

Result<SweepResult> sweep(SweepPlan plan, const SweepOptions& options, const ChunkMaker& make,
                          const Watch& watch) {
  const ChunkedRows& work = plan.rows;
  const std::size_t width = work.columns.size() - 1;
  if (auto good = fits_in_memory(static_cast<double>(work.rows),
                                 static_cast<double>(width) * sizeof(double) + 1, options.memory);
      !good)
    return Error{"rows_can_stream", {{"what", good.error().notice}}};
  SweepResult result{.plan = std::move(plan), .rows = {}, .counts = {}};
  const ChunkedRows& rows = result.plan.rows;
  result.rows.assign(rows.rows * width, std::numeric_limits<double>::quiet_NaN());
  result.statuses.assign(rows.rows, SweepResult::not_reached);
  // Rows that are not reached still have their swept values.
  const SweepPoints points(result.plan.work->base, result.plan.work->axes);
  for (std::uint64_t row = 0; row < rows.rows; ++row) points.values_of(row, &result.rows[row * width]);
  std::vector<std::uint64_t> chunks(rows.chunks());
  std::iota(chunks.begin(), chunks.end(), 0);
  const auto sink = [&](std::uint64_t chunk, const double* made) -> Result<void> {
    double* to = result.rows.data() + chunk * rows.rows_per_chunk * width;
    for (std::uint64_t i = 0; i < rows.rows_of(chunk); ++i, to += width, made += width + 1) {
      const std::uint64_t row = chunk * rows.rows_per_chunk + i;
      std::copy_n(made, width, to);
      result.statuses[row] = static_cast<unsigned char>(made[width]);
      count_row(result.plan, row, made, result.counts);
    }
    result.done += rows.rows_of(chunk);
    return {};
  };
  const auto end = make(rows, chunks, options.threads.value_or(0), sink, watch);
  if (!end) return end.error();
  result.interrupted = *end == ChunksEnd::interrupted;
  if (options.check && !result.interrupted) result.check = check_closed_form(result.plan, watch);
  return result;
}

}  // namespace cromer::core
