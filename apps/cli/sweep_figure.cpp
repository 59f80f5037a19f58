#include "sweep_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cromer/study/task/sweep_rows.h"
#include "length_unit.h"

namespace cromer::cli {
namespace {

constexpr std::uint64_t most_curves = 5;

/// The numbers of a column, and what they are called and measured in.
struct Shown {
  std::string name;
  double unit = 1;  ///< of the column's unit
};

/// Lengths in the unit that suits them.
Shown shown(const std::string& column, double largest) {
  if (column.ends_with(" (m)")) {
    const LengthUnit unit = length_unit(largest);
    return {fmt::format("{} ({})", column.substr(0, column.size() - 4), unit.symbol), unit.metres};
  }
  std::string name = column;
  std::replace(name.begin(), name.end(), '_', ' ');
  return {name, 1};
}

/// Even ratios rather than even steps.
bool is_logarithmic(const std::vector<double>& values) {
  if (values.size() < 3 || !(values.front() > 0 && values.back() > 0)) return false;
  const double middle = values[values.size() / 2], ends = std::sqrt(values.front() * values.back());
  const double even = (values.front() + values.back()) / 2;
  return values.back() / values.front() > 5 && std::abs(middle - ends) < std::abs(middle - even);
}

class Drawing {
 public:
  explicit Drawing(const SweepResult& result)
      : result_(result),
        width_(result.plan.rows.columns.size() - 1),
        swept_(result.plan.swept),
        first_(is_both(result)) {}

  /// The first of the swept is the direction.
  static std::size_t is_both(const SweepResult& result) {
    return result.plan.swept.front().name == direction_axis ? 1 : 0;
  }

  Figure draw() const {
    Figure figure;
    figure.id = "sweep";
    figure.title = title();
    const std::size_t inner = swept_.size() - 1;
    const std::uint64_t points = swept_[inner].points;
    const std::uint64_t outer = inner == first_ ? 1 : swept_[first_].points;
    for (std::size_t i = 0; i < result_.plan.measured.size(); ++i) {
      const std::size_t column = swept_.size() + i;
      if (outer <= most_curves)
        figure.panels.push_back(curves(column, outer, points));
      else
        for (std::size_t way = 0; way <= first_; ++way)
          figure.panels.push_back(map(column, outer, points, way));
    }
    figure.size = figure.panels.size() > 1 ? FigureSize::wide : FigureSize::single;
    figure.columns = figure.panels.size() > 1 ? 2 : 1;
    return figure;
  }

 private:
  double at(std::uint64_t row, std::size_t column) const { return result_.rows[row * width_ + column]; }

  std::string title() const {
    std::string over;
    for (std::size_t i = first_; i < swept_.size(); ++i)
      over += fmt::format("{}{}", over.empty() ? "" : " and ", spaced(swept_[i].name));
    return fmt::format("Sweep over {}{}, by {}", over, first_ ? ", up and down" : "", result_.plan.method);
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

  /// Where up and down are farthest apart.
  double widest(std::size_t column, std::uint64_t points) const {
    std::uint64_t place = 0;
    double most = -1;
    for (std::uint64_t i = 0; i < points; ++i)
      if (const double apart = std::abs(at(i, column) - at(points + i, column)); apart > most)
        most = apart, place = i;
    return at(place, swept_.size() - 1);
  }

  /// Up solid and down dashed.
  Panel curves(std::size_t column, std::uint64_t outer, std::uint64_t points) const {
    const Shown measure = shown(result_.plan.rows.columns[column], largest(column));
    Panel panel;
    panel.title = measure.name.substr(0, measure.name.find(" ("));
    if (outer > 1) panel.title += fmt::format(", names: {}", shown(swept_[first_].column, 1e9).name);
    if (outer > 1 && first_) panel.title += ", down dashed";
    panel.y.name = measure.name;
    panel.x.name = shown(swept_.back().column, 1e9).name;
    for (std::uint64_t k = 0; k < outer; ++k)
      for (std::size_t way = 0; way <= first_; ++way) {
        const std::uint64_t begin = (way * outer + k) * points;
        Curve curve;
        for (std::uint64_t i = 0; i < points; ++i) {
          curve.x.push_back(at(begin + i, swept_.size() - 1));
          curve.y.push_back(at(begin + i, column) / measure.unit);
        }
        panel.x.logarithmic = is_logarithmic(curve.x);
        if (curve.x.front() > curve.x.back()) {
          std::reverse(curve.x.begin(), curve.x.end());
          std::reverse(curve.y.begin(), curve.y.end());
        }
        curve.role = outer > 1 ? fmt::format("family:{}", k) : result_.plan.method;
        curve.dashed = way == 1;
        if (outer > 1 && way == 0) curve.name = fmt::format("{:.4g}", at(begin, first_));
        if (outer == 1 && first_) curve.name = way == 0 ? "up" : "down";
        // Each name at its own peak: resonance curves end in one line.
        const auto top = std::max_element(curve.y.begin(), curve.y.end(),
                                          [](double a, double b) { return a < b || std::isnan(a); });
        const auto peak = static_cast<std::size_t>(top - curve.y.begin());
        const bool inside = peak > 0 && peak + 1 < curve.x.size();
        if (!curve.name.empty() && inside) curve.label_x = curve.x[peak];
        if (outer == 1 && first_ && !inside) curve.label_x = widest(column, points);
        panel.curves.push_back(std::move(curve));
      }
    return panel;
  }

  /// The option that runs fastest lies across; of positions and velocities the positions do.
  Panel map(std::size_t column, std::uint64_t outer, std::uint64_t points, std::size_t way) const {
    const Shown measure = shown(result_.plan.rows.columns[column], largest(column));
    const bool phase_plane = swept_[first_].name == "position" && swept_[first_ + 1].name == "velocity";
    const std::size_t across = first_ + (phase_plane ? 0 : 1), up = first_ + (phase_plane ? 1 : 0);
    const std::uint64_t columns = phase_plane ? outer : points, rows = phase_plane ? points : outer;
    const auto row_of = [&](std::uint64_t i, std::uint64_t k) {
      return way * outer * points + (phase_plane ? i * points + k : k * points + i);
    };
    Panel panel;
    panel.title = measure.name.substr(0, measure.name.find(" ("));
    if (first_) panel.title += way == 0 ? ", up" : ", down";
    panel.x.name = shown(swept_[across].column, 1e9).name;
    panel.y.name = shown(swept_[up].column, 1e9).name;
    HeatMap map;
    map.name = measure.name;
    map.decades = panel.title.rfind("phase", 0) != 0;  // an angle has no ratios
    for (std::uint64_t i = 0; i < columns; ++i) map.x.push_back(at(row_of(i, 0), across));
    for (std::uint64_t k = 0; k < rows; ++k) map.y.push_back(at(row_of(0, k), up));
    map.z.reserve(rows * columns);
    for (std::uint64_t k = 0; k < rows; ++k)
      for (std::uint64_t i = 0; i < columns; ++i) map.z.push_back(at(row_of(i, k), column) / measure.unit);
    if (first_) {  // up and down in the same colours
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
  const std::vector<SweptOption>& swept_;
  std::size_t first_;  ///< of the swept options: 1 after the direction
};

}  // namespace

Result<Figure> sweep_figure(const SweepResult& result) {
  const std::size_t options = result.plan.swept.size() - Drawing::is_both(result);
  if (options > 2)
    return Error{fmt::format(
        "--plot: {} options are swept, and a figure has room for two; leave --plot out, or sweep fewer",
        options)};
  return Drawing(result).draw();
}

}  // namespace cromer::cli
