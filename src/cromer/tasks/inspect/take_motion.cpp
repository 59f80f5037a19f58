#include "cromer/tasks/inspect/take_motion.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "cromer/analysis/spectrum.h"
#include "cromer/base/ascii.h"
#include "cromer/base/extent.h"
#include "cromer/read/columns.h"

namespace cromer::core {
namespace {

/// Whether names differ in one letter only, x in the first, y and z in the others: "Gyroscope x (rad/s)".
bool are_axes(const std::vector<const Column*>& columns) {
  if (columns.size() != 3) return false;
  const std::string first = lower(columns[0]->name);
  for (std::size_t k = 1; k < 3; ++k) {
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

/// The axes x, y, z of the sensor whose columns may be the motion, known by their names or not; else none.
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

/// A swing that stands out from all else that its axis shows.
struct AxisSwing {
  double amplitude = 0;
  double clearness = 0;  ///< the amplitude times the line's share of the variance
};

AxisSwing swing_in(std::span<const double> t, std::span<const double> y, double rate) {
  const auto line = strongest_line(least_squares_spectrum(t, y, 1 / rate));
  if (!line) return {};
  double mean = 0, variance = 0;
  for (const double each : y) mean += each / static_cast<double>(y.size());
  for (const double each : y) variance += (each - mean) * (each - mean) / static_cast<double>(y.size());
  const double share = std::min(1.0, 0.5 * line->amplitude * line->amplitude / variance);
  return {line->amplitude, line->amplitude * share};
}

/// That of the quarter of the record where it is clearest: it may die down, and hands move a phone.
AxisSwing clearest_swing(const Series& series) {
  constexpr std::size_t fewest = 64;
  const std::size_t n = series.t.size(), parts = n >= 4 * fewest ? 4 : 1;
  AxisSwing clearest;
  if (n < 4 || !(series.rate > 0)) return clearest;
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t first = part * n / parts, count = (part + 1) * n / parts - first;
    const auto y = std::span(series.y).subspan(first, count);
    const auto [low, high] = extent_of(y);
    if (low == high) continue;
    const AxisSwing here = swing_in(std::span(series.t).subspan(first, count), y, series.rate);
    if (here.clearness > clearest.clearness) clearest = here;
  }
  return clearest;
}

}  // namespace

Result<Series> take_motion(const Recording& recording, std::string_view column, int run,
                           const ReadOptions& options) {
  Result<Series> series = take_series(recording, column, run, options);
  if (series || !column.empty()) return series;
  struct Axis {
    Series series;
    AxisSwing swing;
  };
  std::vector<Axis> found;
  for (const Column* axis : axes_of(recording, run)) {
    auto taken = take_series(recording, column_title(*axis), run, options);
    if (!taken) return series;
    const AxisSwing swing = clearest_swing(*taken);
    found.push_back({*std::move(taken), swing});
  }
  std::stable_sort(found.begin(), found.end(), [](const Axis& one, const Axis& other) {
    return one.swing.clearness > other.swing.clearness;
  });
  if (found.empty() || !(found.front().swing.clearness > 0)) return series;
  Series liveliest = std::move(found.front().series);
  const std::string unit = unit_of(liveliest);
  liveliest.notices.insert(liveliest.notices.begin(), Notice{"liveliest_axis_taken",
                                                             {{"column", liveliest.column},
                                                              {"amplitude", found[0].swing.amplitude},
                                                              {"other", found[1].series.column},
                                                              {"less", found[1].swing.amplitude},
                                                              {"unit", unit.empty() ? unit : " " + unit}}});
  return liveliest;
}

}  // namespace cromer::core
