#include "cromer/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cromer/base/length_unit.h"
#include "cromer/documents/text/words.h"
#include "cromer/report/palette.h"
#include "cromer/tasks/sweep/sweep_rows.h"

namespace cromer::core {
namespace {

constexpr std::uint64_t most_curves = 5;

/// The name and the unit in which a column is drawn.
struct Shown {
  std::string name;
  double unit = 1;  ///< in the unit of the column
};

/// Lengths are drawn in a suitable unit.
Shown shown(const std::string& column, double largest) {
  if (column.ends_with(" (m)")) {
    const LengthUnit unit = length_unit(largest);
    return {fmt::format("{} ({})", column.substr(0, column.size() - 4), unit.symbol), unit.metres};
  }
  std::string name = column;
  std::replace(name.begin(), name.end(), '_', ' ');
  return {name, 1};
}

/// The name of a measure. The last state has symbols alone.
Shown measure_shown(const std::string& column, double largest) {
  Shown measure = shown(column, largest);
  for (const auto& [symbol, name] :
       {std::pair{"x (", "final position {/:Italic x} ("}, std::pair{"v (", "final velocity {/:Italic v} ("}})
    if (measure.name.starts_with(symbol)) measure.name.replace(0, 3, name);
  return measure;
}

/// Whether the values have even ratios rather than even steps.
bool is_logarithmic(const std::vector<double>& values) {
  if (values.size() < 3 || !(values.front() > 0 && values.back() > 0)) return false;
  const double middle = values[values.size() / 2], ends = std::sqrt(values.front() * values.back());
  const double even = (values.front() + values.back()) / 2;
  const double ratio = values.back() / values.front();
  return std::max(ratio, 1 / ratio) > 5 && std::abs(middle - ends) < std::abs(middle - even);
}

class Drawing {
 public:
  /// `axes`: indices of one swept option, or of two with the outer first.
  Drawing(const SweepResult& result, const std::vector<std::size_t>& axes)
      : result_(result),
        width_(result.plan.rows.columns.size() - 1),
        axes_(axes),
        ways_(goes_both_ways(result) ? 2 : 1) {}

  /// Whether the frequency goes up and down. The direction is then the first of the swept options.
  static bool goes_both_ways(const SweepResult& result) {
    return result.plan.swept.front().name == direction_axis;
  }

  Figure draw() const {
    Figure figure;
    figure.id = "sweep";
    figure.title = title();
    const std::uint64_t points = swept(axes_.back()).points;
    const std::uint64_t outer = axes_.size() == 1 ? 1 : swept(axes_.front()).points;
    for (std::size_t i = 0; i < result_.plan.measured.size(); ++i) {
      const std::size_t column = result_.plan.swept.size() + i;
      if (outer <= most_curves)
        figure.panels.push_back(curves(column, outer, points));
      else
        for (std::size_t way = 0; way < ways_; ++way)
          figure.panels.push_back(map(column, outer, points, way));
    }
    figure.size = figure.panels.size() > 1 ? FigureSize::wide : FigureSize::single;
    figure.columns = figure.panels.size() > 1 ? 2 : 1;
    return figure;
  }

 private:
  const SweptOption& swept(std::size_t axis) const { return result_.plan.swept[axis]; }
  double at(std::uint64_t row, std::size_t column) const { return result_.rows[row * width_ + column]; }
  /// The value of a swept option in the unit of its grid.
  double place(std::uint64_t row, std::size_t axis) const { return at(row, axis) / swept(axis).shown_unit; }
  std::string axis_name(std::size_t axis) const {
    std::string name = swept(axis).shown;
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
  }

  std::string title() const {
    std::string over;
    for (const std::size_t axis : axes_)
      over += fmt::format("{}{}", over.empty() ? "" : " and ", spaced(swept(axis).name));
    return fmt::format("Sweep over {}{}, by {}", over, ways_ == 2 ? ", up and down" : "",
                       method_in_words(result_.plan.method));
  }

  static std::string spaced(std::string name) {
    std::replace(name.begin(), name.end(), '-', ' ');
    return name;
  }

  double largest(std::size_t column) const {
    double size = 0;
    for (std::uint64_t row = 0; row < result_.plan.rows.rows; ++row)
      if (const double value = std::abs(at(row, column)); value > size) size = value;
    return size;
  }

  std::pair<double, double> range(std::size_t column) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::uint64_t row = 0; row < result_.plan.rows.rows; ++row)
      if (const double value = at(row, column); std::isfinite(value))
        low = std::min(low, value), high = std::max(high, value);
    return {low, high};
  }

  bool has_numbers(std::uint64_t first, std::uint64_t points, std::size_t column) const {
    for (std::uint64_t row = first; row < first + points; ++row)
      if (std::isfinite(at(row, column))) return true;
    return false;
  }

  /// The place where up and down are farthest apart.
  double widest(std::size_t column, std::uint64_t points) const {
    std::uint64_t where = 0;
    double most = -1;
    for (std::uint64_t i = 0; i < points; ++i)
      if (const double apart = std::abs(at(i, column) - at(points + i, column)); apart > most)
        most = apart, where = i;
    return place(where, axes_.back());
  }

  /// A curve for each value of the outer option; up solid, down dashed.
  Panel curves(std::size_t column, std::uint64_t outer, std::uint64_t points) const {
    const Shown measure = measure_shown(result_.plan.rows.columns[column], largest(column));
    Panel panel;
    panel.title = measure.name.substr(0, measure.name.find(" ("));
    if (outer > 1) panel.title += fmt::format(" for each {}", axis_name(axes_.front()));
    if (outer > 1 && ways_ == 2) panel.title += ", down dashed";
    panel.y.name = measure.name;
    panel.x.name = axis_name(axes_.back());
    std::string without;  // names of curves that have no numbers
    for (std::uint64_t k = 0; k < outer; ++k)
      for (std::size_t way = 0; way < ways_; ++way) {
        const std::uint64_t begin = (way * outer + k) * points;
        Curve curve;
        for (std::uint64_t i = 0; i < points; ++i) {
          curve.x.push_back(place(begin + i, axes_.back()));
          curve.y.push_back(at(begin + i, column) / measure.unit);
        }
        curve.with_dots = points <= 2;
        panel.x.logarithmic = is_logarithmic(curve.x);
        if (curve.x.front() > curve.x.back()) {
          std::reverse(curve.x.begin(), curve.x.end());
          std::reverse(curve.y.begin(), curve.y.end());
        }
        curve.role = outer > 1 ? family_role(k, outer) : result_.plan.method;
        curve.dashed = way == 1;
        if (outer > 1 && way == 0) curve.name = fmt::format("{:.4g}", place(begin, axes_.front()));
        if (outer == 1 && ways_ == 2) curve.name = way == 0 ? "up" : "down";
        if (!curve.name.empty() && !has_numbers(begin, points, column)) {
          // A label without a curve has no place of its own.
          without += (without.empty() ? "" : ", ") + curve.name;
          curve.name.clear();
        }
        // Each label at its own peak, since resonance curves meet at both ends.
        const auto top = std::max_element(curve.y.begin(), curve.y.end(),
                                          [](double a, double b) { return a < b || std::isnan(a); });
        const auto peak = static_cast<std::size_t>(top - curve.y.begin());
        const bool inside = peak > 0 && peak + 1 < curve.x.size();
        if (!curve.name.empty() && inside) curve.label_x = curve.x[peak];
        if (outer == 1 && ways_ == 2 && !inside) curve.label_x = widest(column, points);
        panel.curves.push_back(std::move(curve));
      }
    if (!without.empty()) panel.title += fmt::format(", no numbers: {}", without);
    return panel;
  }

  /// A map. The inner option runs across; in the phase plane the position does.
  Panel map(std::size_t column, std::uint64_t outer, std::uint64_t points, std::size_t way) const {
    const Shown measure = measure_shown(result_.plan.rows.columns[column], largest(column));
    const std::size_t first = axes_.front(), second = axes_.back();
    const bool phase_plane = swept(first).name == "position" && swept(second).name == "velocity";
    const std::size_t across = phase_plane ? first : second, upward = phase_plane ? second : first;
    const std::uint64_t columns = phase_plane ? outer : points, rows = phase_plane ? points : outer;
    const auto row_of = [&](std::uint64_t i, std::uint64_t k) {
      return way * outer * points + (phase_plane ? i * points + k : k * points + i);
    };
    Panel panel;
    panel.title = measure.name.substr(0, measure.name.find(" ("));
    if (ways_ == 2) panel.title += way == 0 ? ", up" : ", down";
    panel.x.name = axis_name(across);
    panel.y.name = axis_name(upward);
    HeatMap map;
    map.name = measure.name;
    map.decades = panel.title.rfind("phase", 0) != 0;  // an angle has no ratios
    for (std::uint64_t i = 0; i < columns; ++i) map.x.push_back(place(row_of(i, 0), across));
    for (std::uint64_t k = 0; k < rows; ++k) map.y.push_back(place(row_of(0, k), upward));
    map.z.reserve(rows * columns);
    for (std::uint64_t k = 0; k < rows; ++k)
      for (std::uint64_t i = 0; i < columns; ++i) map.z.push_back(at(row_of(i, k), column) / measure.unit);
    if (ways_ == 2) {  // up and down in the same colours
      const auto [low, high] = range(column);
      map.reach = {low / measure.unit, high / measure.unit};
    }
    panel.x.logarithmic = is_logarithmic(map.x);
    panel.y.logarithmic = is_logarithmic(map.y);
    panel.map = std::move(map);
    return panel;
  }

  const SweepResult& result_;
  std::size_t width_;
  const std::vector<std::size_t>& axes_;
  std::size_t ways_;  ///< 2: up, then down
};

}  // namespace

Result<Figure> sweep_figure(const SweepResult& result) {
  // An option with a single value is no axis, unless there is no other.
  std::vector<std::size_t> axes;
  for (std::size_t i = Drawing::goes_both_ways(result) ? 1 : 0; i < result.plan.swept.size(); ++i)
    if (result.plan.swept[i].points > 1) axes.push_back(i);
  if (axes.empty()) axes.push_back(result.plan.swept.size() - 1);
  if (axes.size() > 2) return Error{"figure_of_two_axes", {{"options", axes.size()}}};
  return Drawing(result, axes).draw();
}

}  // namespace cromer::core
