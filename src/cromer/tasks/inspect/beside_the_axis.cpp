#include "cromer/tasks/inspect/beside_the_axis.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cromer/base/pi.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/columns.h"
#include "cromer/tasks/inspect/axis_swing.h"

namespace cromer::core {
namespace {

double correlation(std::span<const double> a, std::span<const double> b) {
  const auto n = static_cast<double>(a.size());
  double sum_a = 0, sum_b = 0, squares_a = 0, squares_b = 0, both = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum_a += a[i], sum_b += b[i];
    squares_a += a[i] * a[i], squares_b += b[i] * b[i], both += a[i] * b[i];
  }
  const double variances = (squares_a - sum_a * sum_a / n) * (squares_b - sum_b * sum_b / n);
  return variances > 0 ? (both - sum_a * sum_b / n) / std::sqrt(variances) : 0;
}

std::vector<double> rate_of_change(const Series& series) {
  std::vector<double> rates(series.y.size());
  for (std::size_t i = 1; i + 1 < rates.size(); ++i)
    rates[i] = (series.y[i + 1] - series.y[i - 1]) / (series.t[i + 1] - series.t[i - 1]);
  return rates;
}

}  // namespace

Notice turns_round(const Series& axis, std::span<const double> during, const AxisSwing& swing) {
  if (axis.quantity != "angular velocity") return {};
  double sum = 0, squares = 0;
  for (const double rate : during) sum += rate, squares += rate * rate;
  const auto count = static_cast<double>(during.size());
  const double mean = sum / count, spread = std::sqrt(std::max(0.0, squares / count - mean * mean));
  constexpr double steadily = 3, alike = 0.2;
  if (!(std::abs(mean) > steadily * spread && std::abs(mean) > swing.amplitude)) return {};
  if (std::abs(swing.angular_frequency - std::abs(mean)) > alike * std::abs(mean)) return {};
  return Notice{"sensor_turns_round", {{"axis", axis.column}, {"mean", mean}}};
}

Notice swings_alongside(const Recording& recording, const Series& taken, int run,
                        const ReadOptions& options) {
  if (recording.named || !(taken.rate > 0) || taken.t.size() < 64) return {};
  constexpr double clearly = 0.3, the_same = 0.8;  // of the variance, and a correlation
  const AxisSwing swing = swing_in(taken.t, taken.y, taken.rate);
  if (!(swing.angular_frequency > 0)) return {};
  const double resolution = two_pi / (taken.t.back() - taken.t.front());
  const std::vector<double> rates = rate_of_change(taken);
  for (const Column& column : recording.table.columns) {
    if (column.run != run || !column.quantity.empty() || column_title(column) == taken.column) continue;
    const auto other = take_series(recording, column_title(column), run, options);
    if (!other || other->t != taken.t) continue;
    const AxisSwing its_own = swing_in(other->t, other->y, other->rate);
    if (its_own.share < clearly ||
        std::abs(its_own.angular_frequency - swing.angular_frequency) > resolution ||
        std::abs(correlation(taken.y, other->y)) > the_same ||
        std::abs(correlation(rates, other->y)) > the_same)
      continue;
    return Notice{"swings_alongside", {{"column", taken.column}, {"other", other->column}}};
  }
  return {};
}

}  // namespace cromer::core
