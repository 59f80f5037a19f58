#include "cromer/tasks/inspect/take_motion.h"

#include <algorithm>
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
  if (!are_axes(axes)) axes.clear();
  return axes;
}

double strength(const Series& series) {
  const auto [low, high] = extent_of(series.y);
  if (series.t.size() < 4 || !(series.rate > 0) || low == high) return 0;
  const auto line = strongest_line(least_squares_spectrum(series.t, series.y, 1 / series.rate));
  return line ? line->amplitude : 0;
}

}  // namespace

Result<Series> take_motion(const Recording& recording, std::string_view column, int run,
                           const ReadOptions& options) {
  Result<Series> series = take_series(recording, column, run, options);
  if (series || !column.empty()) return series;
  struct Axis {
    Series series;
    double strength;
  };
  std::vector<Axis> found;
  for (const Column* axis : axes_of(recording, run)) {
    auto taken = take_series(recording, column_title(*axis), run, options);
    if (!taken) return series;
    const double strong = strength(*taken);
    found.push_back({*std::move(taken), strong});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Axis& one, const Axis& other) { return one.strength > other.strength; });
  if (found.empty() || !(found.front().strength > 0)) return series;
  Series liveliest = std::move(found.front().series);
  liveliest.notices.insert(liveliest.notices.begin(), Notice{"liveliest_axis_taken",
                                                             {{"column", liveliest.column},
                                                              {"amplitude", found[0].strength},
                                                              {"other", found[1].series.column},
                                                              {"less", found[1].strength},
                                                              {"unit", unit_of(liveliest)}}});
  return liveliest;
}

}  // namespace cromer::core
