#include "cromer/read/channels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/base/add_once.h"
#include "cromer/read/columns.h"
#include "cromer/read/samples_between.h"

namespace cromer::core {
namespace {

/// The times of all series; those that differ by less than a thousandth of a step are one.
std::vector<double> common_times(const std::vector<Series>& all, double step) {
  std::vector<double> times;
  for (const Series& series : all) times.insert(times.end(), series.t.begin(), series.t.end());
  std::sort(times.begin(), times.end());
  times.erase(
      std::unique(times.begin(), times.end(), [&](double a, double b) { return b - a < 1e-3 * step; }),
      times.end());
  return times;
}

/// The series' values at these times.
Channel channel_of(const Series& series, const std::vector<double>& times, double step) {
  Channel channel{.column = series.column, .resolution = series.resolution, .missing = times.size()};
  channel.y.assign(times.size(), std::numeric_limits<double>::quiet_NaN());
  auto aside = series.outliers.begin();
  for (std::size_t n = 0, i = 0; n < series.t.size(); ++n) {
    if (aside != series.outliers.end() && aside->t == series.t[n]) {
      ++aside;
      continue;
    }
    while (times[i] < series.t[n] - 1e-3 * step) ++i;
    channel.y[i] = series.y[n];
    --channel.missing;
  }
  return channel;
}

}  // namespace

Result<Channels> take_channels(const Recording& recording, const std::optional<int>& run,
                               const ReadOptions& options) {
  if (const std::size_t several = runs(recording).size(); several > 1 && !run)
    return Error{"choose_one_run", {{"file", recording.file}, {"runs", several}}};
  Channels channels{.run = run.value_or(1)};
  if (auto known = check_run(recording, channels.run); !known) return known.error();
  std::vector<Series> all;
  for (const std::size_t j : motion_columns(recording, channels.run)) {
    const Column& column = recording.table.columns[j];
    if (std::none_of(column.values.begin(), column.values.end(), [](double y) { return std::isfinite(y); })) {
      all.emplace_back().column = column_title(column);
      continue;
    }
    auto series = take_series(recording, column_title(column), channels.run, options);
    if (!series) return series.error();
    for (const Notice& notice : series->notices) add_once(channels.notices, notice);
    all.push_back(*std::move(series));
  }
  auto first = std::find_if(all.begin(), all.end(), [](const Series& series) { return !series.t.empty(); });
  if (first == all.end()) {
    // Where no column is a motion by name, take_series says what there is.
    auto only = take_series(recording, "", channels.run, options);
    if (!only) return only.error();
    channels.notices = only->notices;
    all.assign(1, *std::move(only));
    first = all.begin();
  }
  channels.quantity = first->quantity;
  channels.unit = unit_of(*first);
  channels.rate = first->rate;
  const double step = channels.rate > 0 ? 1 / channels.rate : 0;
  channels.t = common_times(all, step);
  for (const Series& series : all) channels.each.push_back(channel_of(series, channels.t, step));
  return channels;
}

Result<void> crop(Channels& channels, const std::optional<double>& from, const std::optional<double>& to) {
  const auto part = samples_between(channels.t, channels.rate, from, to);
  if (!part) return part.error();
  const auto begin = static_cast<std::ptrdiff_t>(part->first), end = static_cast<std::ptrdiff_t>(part->end);
  for (Channel& channel : channels.each) {
    channel.y = {channel.y.begin() + begin, channel.y.begin() + end};
    channel.missing = static_cast<std::size_t>(
        std::count_if(channel.y.begin(), channel.y.end(), [](double y) { return std::isnan(y); }));
  }
  channels.t = {channels.t.begin() + begin, channels.t.begin() + end};
  return {};
}

bool never_changes(const Channel& channel) {
  std::optional<double> level;
  for (const double y : channel.y) {
    if (std::isnan(y)) continue;
    if (level && y != *level) return false;
    level = y;
  }
  return true;
}

std::size_t leave_out_incomplete(Channels& channels) {
  const std::size_t all = channels.t.size();
  std::size_t kept = 0;
  for (std::size_t n = 0; n < all; ++n) {
    if (std::any_of(channels.each.begin(), channels.each.end(),
                    [&](const Channel& channel) { return std::isnan(channel.y[n]); }))
      continue;
    for (Channel& channel : channels.each) channel.y[kept] = channel.y[n];
    channels.t[kept++] = channels.t[n];
  }
  channels.t.resize(kept);
  for (Channel& channel : channels.each) channel.y.resize(kept), channel.missing = 0;
  return all - kept;
}

}  // namespace cromer::core
