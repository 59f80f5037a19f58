#include "cromer/tasks/fit/used_samples.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cromer/base/quantile.h"
#include "cromer/identify/diagnose/free_part.h"
#include "cromer/identify/diagnose/outliers.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/samples_between.h"
#include "cromer/read/series_shape.h"

namespace cromer::core {
namespace {

// Sums of squares must neither overflow nor vanish.
Result<void> check_size(const Series& series) {
  double largest = 0;
  for (const double y : series.y) largest = std::max(largest, std::abs(y));
  constexpr double most = 1e100, least = 1e-100;
  if (largest == 0 || (largest > least && largest < most)) return {};
  // A stray value may be as large.
  std::vector<double> sizes;
  for (const double y : series.y) sizes.push_back(std::abs(y));
  const double middle = upper_median(sizes);
  if (middle < most && largest > least) return {};
  return Error{Notice{middle < 1 ? "values_too_small" : "values_too_large",
                      {{"column", series.column}, {"value", middle}}}};
}

/// Cuts the series off where the sensor has lost the motion for good, with a notice.
void cut_lost_motion(Series& series) {
  const auto lost = find_lost_motion({series.t, series.y, series.resolution});
  if (!lost) return;
  const std::size_t all = series.t.size();
  FitOptions before;
  before.to = series.t[lost->seen - 1];
  const double from = series.t[lost->seen];
  series = *used_part(std::move(series), before);
  series.notices.push_back(Notice{"sensor_loses_motion",
                                  {{"from", from},
                                   {"value", lost->value},
                                   {"unit", unit_of(series)},
                                   {"share", 100 * lost->share},
                                   {"seen", lost->seen},
                                   {"samples", all}}});
}

/// Adds these samples to the outliers, with a notice, but for those that are among them.
void set_samples_aside(Series& series, const std::vector<std::size_t>& found, std::string_view code) {
  if (found.empty()) return;
  const FittedSamples kept = without_outliers(series);
  std::size_t added = 0, first = 0;
  for (std::size_t i : found) {
    if (!std::binary_search(kept.t.begin(), kept.t.end(), series.t[i])) continue;
    series.outliers.push_back({series.t[i], series.y[i], i < series.lines.size() ? series.lines[i] : 0});
    if (added++ == 0) first = i;
  }
  if (added == 0) return;
  std::sort(series.outliers.begin(), series.outliers.end(),
            [](const Outlier& a, const Outlier& b) { return a.t < b.t; });
  Notice aside{std::string(code)};
  aside.values = {{"samples", added}, {"first", series.t[first]}};
  series.notices.push_back(std::move(aside));
}

/// Where the sensor was out of its range the motion is not told, and the rest of it is.
void set_cut_tops_aside(Series& series) {
  if (!(series.rate > 0)) return;
  std::erase_if(series.notices, [](const Notice& notice) { return notice.code == "column_tops_cut_off"; });
  const std::vector<double> levels = dialects::tops_cut_off(series.y, 1 / series.rate, series.resolution);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < series.y.size(); ++i)
    if (std::find(levels.begin(), levels.end(), series.y[i]) != levels.end()) found.push_back(i);
  set_samples_aside(series, found, "cut_tops_aside");
}

}  // namespace

Series without_slip(Series series, const TimeSlip& slip) {
  remove_slip(slip, series.t, series.y, series.lines);
  for (Gap& gap : series.gaps)
    if (gap.t >= slip.at) gap.t -= slip.by;
  for (Outlier& outlier : series.outliers)
    if (outlier.t >= slip.at) outlier.t -= slip.by;
  series.slips_at = slip.at - slip.by;
  series.slips_by = slip.by;
  return series;
}

Result<Series> used_part(Series series, const FitOptions& options) {
  const std::size_t n = series.t.size();
  if (n == 0) return Error{"column_has_no_values", {{"column", series.column}}};
  const auto part = samples_between(series.t, series.rate, options.from, options.to);
  if (!part) return part.error();
  const auto first = static_cast<std::ptrdiff_t>(part->first), last = static_cast<std::ptrdiff_t>(part->end);
  if (const Result<void> good = check_size(series); !good) return good.error();
  const auto cut = [&](auto& values) {
    if (values.size() != n) return;
    values.erase(values.begin() + last, values.end());
    values.erase(values.begin(), values.begin() + first);
  };
  cut(series.t);
  cut(series.y);
  cut(series.lines);
  const auto outside = [&](const auto& mark) {
    return mark.t < series.t.front() || mark.t > series.t.back();
  };
  std::erase_if(series.gaps, outside);
  std::erase_if(series.outliers, outside);
  return series;
}

FittedRecording row_to_fit(const Series& series, Series used, std::string_view file,
                           const FitOptions& options) {
  FittedRecording row;
  row.file = file;
  row.samples = series.t.size();
  row.options = options;
  row.notices = used.notices;
  row.series = std::move(used);
  return row;
}

FittedSamples without_outliers(const Series& series) {
  if (series.outliers.empty()) return {series.t, series.y};
  FittedSamples kept;
  std::vector<double> times;
  for (const Outlier& outlier : series.outliers) times.push_back(outlier.t);
  std::sort(times.begin(), times.end());
  for (std::size_t i = 0; i < series.t.size(); ++i) {
    if (std::binary_search(times.begin(), times.end(), series.t[i])) continue;
    kept.t.push_back(series.t[i]);
    kept.y.push_back(series.y[i]);
  }
  return kept;
}

Result<Series> samples_in_use(Series series, const FitOptions& options) {
  Result<Series> used = used_part(std::move(series), options);
  if (!used) return used;
  if (!options.from && !options.to) cut_lost_motion(*used);
  set_cut_tops_aside(*used);
  set_samples_aside(*used, drop_outs({used->t, used->y, used->resolution}), "drop_outs_aside");
  return used;
}

Record record_of(const Series& series, std::span<const double> t, std::span<const double> y) {
  return {t,
          y,
          series.resolution,
          std::max(0, derivative_order(series.quantity)),
          series.clock_error,
          series.scale_error,
          series.slips_at,
          series.handled_first,
          series.handled_last,
          unit_of(series)};
}

void list_outliers(Series& series, const FittedSamples& samples, const std::vector<std::size_t>& aside,
                   std::vector<Notice>& notices) {
  if (aside.empty()) return;
  for (const std::size_t i : aside) {
    const auto at = static_cast<std::size_t>(
        std::lower_bound(series.t.begin(), series.t.end(), samples.t[i]) - series.t.begin());
    series.outliers.push_back({samples.t[i], samples.y[i], at < series.lines.size() ? series.lines[at] : 0});
  }
  std::sort(series.outliers.begin(), series.outliers.end(),
            [](const Outlier& a, const Outlier& b) { return a.t < b.t; });
  notices.push_back(Notice{aside.size() == 1 ? "sample_aside" : "samples_aside",
                           {{"samples", aside.size()}, {"first", samples.t[aside.front()]}}});
}

int derivative_order(std::string_view quantity) {
  if (quantity == "position" || quantity == "angle") return 0;
  if (quantity == "velocity" || quantity == "angular velocity") return 1;
  if (quantity == "acceleration" || quantity == "angular acceleration") return 2;
  return -1;
}

bool is_linear_quantity(std::string_view quantity) {
  return quantity.empty() || quantity == "position" || quantity == "velocity" || quantity == "acceleration";
}

Notice fitted_as_it_is(std::string_view quantity, std::string_view column) {
  const bool angle = quantity.starts_with("ang");
  return Notice{angle ? "fitted_as_it_is_of_angle" : "fitted_as_it_is",
                {{"column", column}, {"kind", kind_of(quantity)}}};
}

}  // namespace cromer::core
