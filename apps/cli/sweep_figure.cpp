#include "sweep_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/report/palette.h"
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
      : result_(result), width_(result.plan.rows.columns.size() - 1), swept_(result.plan.swept) {}

  Figure draw() const {
    Figure figure;
    figure.id = "sweep";
    figure.title = title();
    const std::size_t inner = swept_.size() - 1;
    const std::uint64_t points = swept_[inner].points;
    const std::uint64_t outer = inner == 0 ? 1 : swept_[0].points;
    for (std::size_t i = 0; i < result_.plan.measured.size(); ++i) {
      const std::size_t column = swept_.size() + i;
      figure.panels.push_back(outer <= most_curves ? curves(column, outer, points)
                                                   : map(column, outer, points));
    }
    figure.size = figure.panels.size() > 1 ? FigureSize::wide : FigureSize::single;
    figure.columns = figure.panels.size() > 1 ? 2 : 1;
    return figure;
  }

 private:
  double at(std::uint64_t row, std::size_t column) const { return result_.rows[row * width_ + column]; }

  std::string title() const {
    std::string over;
    for (const SweptOption& option : swept_)
      over += fmt::format("{}{}", over.empty() ? "" : " and ", spaced(option.name));
    return fmt::format("Sweep over {}, by {}", over, result_.plan.method);
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

  Panel curves(std::size_t column, std::uint64_t outer, std::uint64_t points) const {
    const Shown measure = shown(result_.plan.rows.columns[column], largest(column));
    Panel panel;
    panel.title = measure.name.substr(0, measure.name.find(" ("));
    if (outer > 1) panel.title += fmt::format(", names: {}", shown(swept_[0].column, 1e9).name);
    panel.y.name = measure.name;
    panel.x.name = shown(swept_.back().column, 1e9).name;
    for (std::uint64_t k = 0; k < outer; ++k) {
      Curve curve;
      for (std::uint64_t i = 0; i < points; ++i) {
        curve.x.push_back(at(k * points + i, swept_.size() - 1));
        curve.y.push_back(at(k * points + i, column) / measure.unit);
      }
      curve.with_dots = points <= 2;
      panel.x.logarithmic = is_logarithmic(curve.x);
      if (curve.x.front() > curve.x.back()) {
        std::reverse(curve.x.begin(), curve.x.end());
        std::reverse(curve.y.begin(), curve.y.end());
      }
      curve.role = outer > 1 ? family_role(k, outer) : result_.plan.method;
      // Each name at its own peak: resonance curves end in one line.
      const auto top = std::max_element(curve.y.begin(), curve.y.end(),
                                        [](double a, double b) { return a < b || std::isnan(a); });
      const auto peak = static_cast<std::size_t>(top - curve.y.begin());
      if (outer > 1 && peak > 0 && peak + 1 < curve.x.size()) curve.label_x = curve.x[peak];
      curve.name = outer > 1 ? fmt::format("{:.4g}", at(k * points, 0)) : "";
      panel.curves.push_back(std::move(curve));
    }
    return panel;
  }

  /// The option that runs fastest lies across; of positions and velocities the positions do.
  Panel map(std::size_t column, std::uint64_t outer, std::uint64_t points) const {
    const Shown measure = shown(result_.plan.rows.columns[column], largest(column));
    const bool phase_plane = swept_[0].name == "position" && swept_[1].name == "velocity";
    const std::size_t across = phase_plane ? 0 : 1;
    const std::uint64_t columns = phase_plane ? outer : points, rows = phase_plane ? points : outer;
    const auto row_of = [&](std::uint64_t i, std::uint64_t k) {
      return phase_plane ? i * points + k : k * points + i;
    };
    Panel panel;
    panel.title = measure.name.substr(0, measure.name.find(" ("));
    panel.x.name = shown(swept_[across].column, 1e9).name;
    panel.y.name = shown(swept_[1 - across].column, 1e9).name;
    HeatMap map;
    map.name = measure.name;
    for (std::uint64_t i = 0; i < columns; ++i) map.x.push_back(at(row_of(i, 0), across));
    for (std::uint64_t k = 0; k < rows; ++k) map.y.push_back(at(row_of(0, k), 1 - across));
    map.z.reserve(rows * columns);
    for (std::uint64_t k = 0; k < rows; ++k)
      for (std::uint64_t i = 0; i < columns; ++i) map.z.push_back(at(row_of(i, k), column) / measure.unit);
    panel.x.logarithmic = is_logarithmic(map.x);
    panel.y.logarithmic = is_logarithmic(map.y);
    panel.map = std::move(map);
    return panel;
  }

  const SweepResult& result_;
  std::size_t width_;
  const std::vector<SweptOption>& swept_;
};

}  // namespace

Result<Figure> sweep_figure(const SweepResult& result) {
  if (result.plan.swept.size() > 2)
    return Error{fmt::format(
        "--plot: {} options are swept, and a figure has room for two; leave --plot out, or sweep fewer",
        result.plan.swept.size())};
  return Drawing(result).draw();
}

}  // namespace cromer::cli
