#include "cromer/tasks/inspect/take_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cromer/base/ascii.h"
#include "cromer/base/extent.h"
#include "cromer/base/for_page.h"
#include "cromer/base/pi.h"
#include "cromer/read/angle_about_pivot.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/columns.h"
#include "cromer/tasks/inspect/axis_swing.h"
#include "cromer/tasks/inspect/beside_the_axis.h"

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
    if (are_alike && found.size() == 3) {
      const Series& third = found[2].series;
      const std::size_t n = third.y.size(), first = quarter * n / quarters;
      const auto during = std::span(third.y).subspan(first, (quarter + 1) * n / quarters - first);
      if (Notice turns = turns_round(third, during, found[0].swings[quarter]); !turns.empty())
        liveliest.notices.push_back(std::move(turns));
    }
  return liveliest;
}

}  // namespace cromer::core
