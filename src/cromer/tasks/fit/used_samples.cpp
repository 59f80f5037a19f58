#include "cromer/tasks/fit/used_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/identify/diagnose/drop_outs.h"
#include "cromer/identify/diagnose/free_part.h"

namespace cromer::core {
namespace {

// Sums of squares must neither overflow nor vanish.
Result<void> check_size(const Series& series) {
  std::vector<double> sizes;
  for (const double y : series.y) sizes.push_back(std::abs(y));
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  const double largest = *std::max_element(sizes.begin(), sizes.end());
  constexpr double most = 1e100, least = 1e-100;
  if (*middle < most && (largest == 0 || largest > least)) return {};
  return Error{
      fmt::format("column \"{}\": values like {:.3g} are too {} to be squared; give them in another unit",
                  series.column, *middle, *middle < 1 ? "small" : "large")};
}

}  // namespace

Result<Series> used_part(const Series& series, const FitOptions& options) {
  if (series.t.empty()) return Error{fmt::format("column \"{}\" has no values", series.column)};
  const double from = options.from.value_or(-HUGE_VAL), to = options.to.value_or(HUGE_VAL);
  const double slack = series.rate > 0 ? 1e-6 / series.rate : 0;  // 30 s as typed and as printed by a logger
  const auto first = std::lower_bound(series.t.begin(), series.t.end(), from - slack) - series.t.begin();
  const auto last = std::upper_bound(series.t.begin(), series.t.end(), to + slack) - series.t.begin();
  if (first >= last)
    return Error{fmt::format("{}: no sample is left, the recording goes from {:.6g} to {:.6g} s",
                             !options.to     ? fmt::format("--from {}", from)
                             : !options.from ? fmt::format("--to {}", to)
                                             : fmt::format("--from {} --to {}", from, to),
                             series.t.front(), series.t.back())};
  if (const Result<void> good = check_size(series); !good) return good.error();
  Series used = series;
  const auto cut = [&](auto& values) {
    if (values.size() != series.t.size()) return;
    values.erase(values.begin() + last, values.end());
    values.erase(values.begin(), values.begin() + first);
  };
  cut(used.y);
  cut(used.lines);
  used.t.assign(series.t.begin() + first, series.t.begin() + last);
  const auto outside = [&](const auto& mark) { return mark.t < used.t.front() || mark.t > used.t.back(); };
  used.gaps.erase(std::remove_if(used.gaps.begin(), used.gaps.end(), outside), used.gaps.end());
  used.outliers.erase(std::remove_if(used.outliers.begin(), used.outliers.end(), outside),
                      used.outliers.end());
  return used;
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

void leave_lost_motion(Series& series) {
  const auto lost = find_lost_motion({series.t, series.y, series.resolution});
  if (!lost) return;
  const std::size_t all = series.t.size();
  FitOptions before;
  before.to = series.t[lost->seen - 1];
  const double from = series.t[lost->seen];
  series = *used_part(series, before);
  series.warnings.push_back(fmt::format(
      "the sensor loses the motion at {:.6g} s: in full swing the column stays at {:.4g}{}{} from "
      "there on, in {:.3g} % of the samples. Only what comes before, {} of {} samples, is fitted; "
      "--from and --to choose another part",
      from, lost->value, unit_of(series).empty() ? "" : " ", unit_of(series), 100 * lost->share, lost->seen,
      all));
}

void set_drop_outs_aside(Series& series) {
  const FittedSamples kept = without_outliers(series);
  const std::vector<std::size_t> found = drop_outs({series.t, series.y, series.resolution});
  std::size_t added = 0, first = 0;
  for (std::size_t i : found) {
    if (!std::binary_search(kept.t.begin(), kept.t.end(), series.t[i])) continue;
    series.outliers.push_back({series.t[i], series.y[i], i < series.lines.size() ? series.lines[i] : 0});
    if (added++ == 0) first = i;
  }
  if (added == 0) return;
  std::sort(series.outliers.begin(), series.outliers.end(),
            [](const Outlier& a, const Outlier& b) { return a.t < b.t; });
  series.warnings.push_back(fmt::format(
      "{} samples in flat runs far outside the motion, the first at {:.6g} s, are taken for drop-outs "
      "of the sensor and set aside",
      added, series.t[first]));
}

void list_outliers(Series& series, const FittedSamples& samples, const std::vector<std::size_t>& aside,
                   std::vector<std::string>& warnings) {
  if (aside.empty()) return;
  for (const std::size_t i : aside) {
    const auto at = static_cast<std::size_t>(
        std::lower_bound(series.t.begin(), series.t.end(), samples.t[i]) - series.t.begin());
    series.outliers.push_back({samples.t[i], samples.y[i], at < series.lines.size() ? series.lines[at] : 0});
  }
  std::sort(series.outliers.begin(), series.outliers.end(),
            [](const Outlier& a, const Outlier& b) { return a.t < b.t; });
  warnings.push_back(fmt::format(
      "{} {} far from the fitted motion and from {} neighbours, the first at {:.6g} s, and {} set "
      "aside",
      aside.size() == 1 ? "one sample" : fmt::format("{} samples", aside.size()),
      aside.size() == 1 ? "lies" : "lie", aside.size() == 1 ? "its" : "their", samples.t[aside.front()],
      aside.size() == 1 ? "is" : "are"));
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

std::string fitted_as_it_is(std::string_view quantity, std::string_view column) {
  return fmt::format(
      "column \"{}\" holds {}: it is fitted as that, and all but the equilibrium, which is the sensor's "
      "offset, is said of the {}",
      column, quantity, quantity.starts_with("ang") ? "angle" : "displacement");
}

}  // namespace cromer::core
