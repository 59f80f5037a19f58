#include "cromer/tasks/inspect/take_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cromer/analysis/spectrum.h"
#include "cromer/base/ascii.h"
#include "cromer/base/extent.h"
#include "cromer/base/for_page.h"
#include "cromer/base/pi.h"
#include "cromer/read/angle_about_pivot.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/columns.h"

namespace cromer::core {
namespace {

/// Whether names differ in one letter only, x in the first, y and z in the others: "Gyroscope x (rad/s)". On
/// film there are x and y alone.
bool are_axes(const std::vector<const Column*>& columns) {
  if (columns.size() != 3 && columns.size() != 2) return false;
  const std::string first = lower(columns[0]->name);
  for (std::size_t k = 1; k < columns.size(); ++k) {
    const std::string other = lower(columns[k]->name);
    if (other.size() != first.size()) return false;
    const auto [here, there] = std::mismatch(first.begin(), first.end(), other.begin());
    if (here == first.end() || *here != 'x' || *there != static_cast<char>('x' + k)) return false;
    if (!std::equal(here + 1, first.end(), there + 1)) return false;
  }
  return true;
}

/// The length of the three, which no phone's file is without: it has no sign, and swings at twice the rate.
bool is_magnitude(const Column& column) {
  const std::string name = lower(column.name);
  for (const std::string_view word : {"absolut", "magnitude", "total", "tgf"})
    if (name.find(word) != name.npos) return true;
  return false;
}

/// The axes x, y, z of a sensor, or x and y of a film, whose columns may be the motion, known by their names
/// or not; else none.
std::vector<const Column*> axes_of(const Recording& recording, int run) {
  const auto& columns = recording.table.columns;
  std::vector<std::size_t> alike = motion_columns(recording, run);
  if (alike.empty())
    for (std::size_t j = 0; j < columns.size(); ++j)
      if (columns[j].run == run && columns[j].quantity.empty()) alike.push_back(j);
  std::vector<const Column*> axes;
  for (const std::size_t j : alike)
    if (!is_magnitude(columns[j])) axes.push_back(&columns[j]);
  std::sort(axes.begin(), axes.end(),
            [](const Column* one, const Column* other) { return lower(one->name) < lower(other->name); });
  if (!are_axes(axes)) axes.clear();
  return axes;
}

/// Standard deviation of a column's values, in SI units.
double spread(const Column& column) {
  double sum = 0, squares = 0, n = 0;
  for (const double value : column.values)
    if (std::isfinite(value)) sum += value, squares += value * value, ++n;
  return n > 0 ? to_si(column).factor * std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n))) : 0;
}

/// The strongest line of a stretch of an axis.
struct AxisSwing {
  double amplitude = 0;
  double share = 0;  ///< of the variance

  double clearness() const { return amplitude * share; }
};

AxisSwing swing_in(std::span<const double> t, std::span<const double> y, double rate) {
  const auto [low, high] = extent_of(y);
  // Times far apart would make the spectrum endless.
  constexpr double sparsest = 100;  // mean step over the nominal one
  if (y.size() < 4 || low == high || !(rate > 0)) return {};
  if (!((t.back() - t.front()) * rate < sparsest * static_cast<double>(y.size()))) return {};
  const auto line = strongest_line(least_squares_spectrum(t, y, 1 / rate));
  if (!line) return {};
  double mean = 0, variance = 0;
  for (const double each : y) mean += each / static_cast<double>(y.size());
  for (const double each : y) variance += (each - mean) * (each - mean) / static_cast<double>(y.size());
  return {line->amplitude, std::min(1.0, 0.5 * line->amplitude * line->amplitude / variance)};
}

/// Whether an angle goes through a whole turn, which no swing does.
bool goes_round(const Series& angle) {
  const auto [low, high] = extent_of(angle.y);
  return high - low >= two_pi;
}

constexpr std::size_t quarters = 4;
// Amplitudes whose ratio is above this are alike.
constexpr double alike = 0.8;

struct Axis {
  Series series;
  std::array<AxisSwing, quarters> swings{};
  double score = 0;

  explicit Axis(Series taken) : series(std::move(taken)) {
    const std::size_t n = series.t.size();
    for (std::size_t q = 0; q < quarters; ++q) {
      const std::size_t first = q * n / quarters, count = (q + 1) * n / quarters - first;
      swings[q] = swing_in(std::span(series.t).subspan(first, count),
                           std::span(series.y).subspan(first, count), series.rate);
    }
  }
  /// The quarter in which it swings most clearly.
  std::size_t clearest() const {
    const auto found = std::max_element(
        swings.begin(), swings.end(),
        [](const AxisSwing& a, const AxisSwing& b) { return a.clearness() < b.clearness(); });
    return static_cast<std::size_t>(found - swings.begin());
  }
};

/// Which axis swings is asked in each quarter, as a swing may die down, and hands move a phone: a quarter
/// counts by how clearly anything swings in it.
void rank(std::vector<Axis>& axes) {
  for (std::size_t q = 0; q < quarters; ++q) {
    double sum = 0, clear = 0;
    for (const Axis& axis : axes) {
      sum += axis.swings[q].clearness();
      clear = std::max(clear, axis.swings[q].share);
    }
    if (sum > 0)
      for (Axis& axis : axes) axis.score += clear * axis.swings[q].clearness() / sum;
  }
  std::stable_sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.score > b.score; });
}

/// Whether a gyroscope turns round steadily about its third axis while the other two swing alike; else empty.
[[maybe_unused]] Notice turning_round(const std::vector<Axis>& ranked, std::size_t quarter) {
  if (ranked.size() != 3 || ranked[2].series.quantity != "angular velocity") return {};
  const Series& third = ranked[2].series;
  const std::size_t n = third.y.size(), first = quarter * n / quarters, end = (quarter + 1) * n / quarters;
  double sum = 0, squares = 0;
  for (std::size_t i = first; i < end; ++i) sum += third.y[i], squares += third.y[i] * third.y[i];
  const auto count = static_cast<double>(end - first);
  const double mean = sum / count, spread = std::sqrt(std::max(0.0, squares / count - mean * mean));
  constexpr double steadily = 3;
  if (!(std::abs(mean) > steadily * spread && std::abs(mean) > ranked[0].swings[quarter].amplitude))
    return {};
  return Notice{"sensor_turns_round", {{"axis", third.column}, {"mean", mean}}};
}

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

/// Of a file without names: another column that swings at the same frequency, and is neither the taken one
/// written again nor its rate of change. The motion may then not lie along the taken one. Else empty.
[[maybe_unused]] Notice swings_alongside(const Recording& recording, const Series& taken, int run,
                                         const ReadOptions& options) {
  if (recording.named || !(taken.rate > 0) || taken.t.size() < 64) return {};
  constexpr double clearly = 0.3, the_same = 0.8;  // of the variance, and a correlation
  const auto line_of = [](const Series& series) {
    return strongest_line(least_squares_spectrum(series.t, series.y, 1 / series.rate));
  };
  const auto line = line_of(taken);
  if (!line) return {};
  const std::vector<double> rates = rate_of_change(taken);
  for (const Column& column : recording.table.columns) {
    if (column.run != run || !column.quantity.empty() || column_title(column) == taken.column) continue;
    const auto other = take_series(recording, column_title(column), run, options);
    if (!other || other->t != taken.t) continue;
    const auto its_line = line_of(*other);
    const double resolution = two_pi / (taken.t.back() - taken.t.front());
    if (!its_line || std::abs(its_line->angular_frequency - line->angular_frequency) > resolution ||
        swing_in(other->t, other->y, other->rate).share < clearly ||
        std::abs(correlation(taken.y, other->y)) > the_same ||
        std::abs(correlation(rates, other->y)) > the_same)
      continue;
    return Notice{"swings_alongside", {{"column", taken.column}, {"other", other->column}}};
  }
  return {};
}

}  // namespace

Result<Series> take_motion(const Recording& recording, std::string_view column, int run,
                           const ReadOptions& options) {
  Result<Series> series = take_series(recording, column, run, options);
  if constexpr (!for_page)
    if (series && column.empty())
      if (Notice other = swings_alongside(recording, *series, run, options); !other.empty())
        series->notices.push_back(std::move(other));
  if (series || !column.empty()) return series;
  const std::vector<const Column*> axes = axes_of(recording, run);
  // A pendulum moves sideways: an arc about a centre beside the swing is a spring's, bent by the camera.
  if (axes.size() == 2 && axes[0]->quantity == "position" && spread(*axes[0]) > spread(*axes[1]))
    if (auto angle = take_series(recording, name_of_angle(*axes[0], *axes[1]), run, options);
        angle && !goes_round(*angle))
      return angle;
  std::vector<Axis> found;
  for (const Column* axis : axes) {
    auto taken = take_series(recording, column_title(*axis), run, options);
    if (!taken) return series;
    found.emplace_back(*std::move(taken));
  }
  rank(found);
  if (found.empty() || !(found.front().score > 0)) return series;
  const std::size_t quarter = found.front().clearest();
  Series liveliest = std::move(found.front().series);
  const std::string unit = unit_of(liveliest);
  const double amplitude = found[0].swings[quarter].amplitude, other = found[1].swings[quarter].amplitude;
  const bool are_alike = std::min(amplitude, other) > alike * std::max(amplitude, other);
  liveliest.notices.insert(liveliest.notices.begin(),
                           Notice{are_alike ? "axes_alike" : "liveliest_axis_taken",
                                  {{"column", liveliest.column},
                                   {"amplitude", amplitude},
                                   {"other", found[1].series.column},
                                   {"less", other},
                                   {"unit", unit.empty() ? unit : " " + unit}}});
  if constexpr (!for_page)
    if (Notice turns = turning_round(found, quarter); are_alike && !turns.empty())
      liveliest.notices.push_back(std::move(turns));
  return liveliest;
}

}  // namespace cromer::core
