#include "cromer/figures/figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "cromer/documents/text/words.h"

namespace cromer::core {
namespace {

/// Measured points with error bars, masses in grams; where they lie close to a line they are ringed.
void add_points(Panel& panel, const std::vector<UncertainPoint>& points, double y_unit) {
  Curve dots, bars;
  for (const UncertainPoint& point : points) {
    const double x = 1000 * point.x, y = point.y / y_unit, e = point.y_error / y_unit;
    dots.x.push_back(x);
    dots.y.push_back(y);
    bars.x.insert(bars.x.end(), {x, x, x});
    bars.y.insert(bars.y.end(), {y - e, y + e, std::numeric_limits<double>::quiet_NaN()});
    panel.notes.push_back({.text = "", .x = x, .y = y, .circle = true, .leader = false});
  }
  dots.role = bars.role = "measured";
  dots.mark = Mark::dots;
  dots.name = "measured";
  panel.curves.push_back(std::move(bars));
  panel.curves.push_back(std::move(dots));
}

/// The line through the points, and what it leaves of them; `y` and `rest` name the vertical axes.
Figure line_figure(const std::vector<UncertainPoint>& points, const LineWithErrors& line, const Axis& y,
                   double y_unit, const Axis& rest, double rest_unit, const Estimate& stiffness) {
  double high = 0;
  for (const UncertainPoint& point : points) high = std::max(high, 1.05 * point.x);
  Panel through, left;
  Curve straight, zero;
  for (const double m : {0.0, high}) {
    straight.x.push_back(1000 * m);
    straight.y.push_back(line.at(m) / y_unit);
    zero.x.push_back(1000 * m);
    zero.y.push_back(0);
  }
  straight.role = zero.role = "fitted";
  straight.name = zero.name = "straight line";
  straight.remark = "{/:Italic k} = " + in_words(stiffness, "N/m");
  through.y = y;
  through.curves.push_back(std::move(straight));
  add_points(through, points, y_unit);
  std::vector<UncertainPoint> residuals = points;
  for (UncertainPoint& point : residuals) point.y -= line.at(point.x);
  left.title = "What the line leaves";
  left.y = rest;
  left.curves.push_back(std::move(zero));
  add_points(left, residuals, rest_unit);
  for (Panel* panel : {&through, &left}) {
    panel->x.name = "mass {/:Italic m} (g)";
    panel->x.low = 0;
    panel->x.high = 1000 * high;
  }
  Figure figure;
  figure.size = FigureSize::single;
  figure.panels = {std::move(through), std::move(left)};
  return figure;
}

}  // namespace

Figure static_figure(const StaticStiffness& found) {
  std::vector<UncertainPoint> points;
  for (const Hold& hold : found.holds)
    points.push_back({hold.mass.value, hold.position, hold.mass.uncertainty, error_about_line(found, hold)});
  Axis y, rest;
  y.name = "position (mm)";
  rest.name = "residual (mm)";
  Figure figure = line_figure(points, found.line, y, 1e-3, rest, 1e-3, found.stiffness);
  figure.id = "static";
  figure.title = "Position at rest against mass, and what the line leaves";
  figure.panels.front().title = "Position at rest against mass";
  return figure;
}

Figure mass_line_figure(const MassLine& line) {
  std::vector<UncertainPoint> points;
  for (const MassLinePoint& point : line.points)
    points.push_back({point.mass.value, point.period_square.value, point.mass.uncertainty,
                      std::hypot(point.period_square.standard_error, line.line.extra_scatter)});
  Axis y, rest;
  y.name = "period squared {/:Italic T}^{2} (s²)";
  y.low = 0;
  rest.name = "residual (10^{−3} s²)";
  Figure figure = line_figure(points, line.line, y, 1, rest, 1e-3, line.stiffness);
  figure.id = "mass-line";
  figure.title = "Period squared against mass, and what the line leaves";
  figure.panels.front().title = "Period squared against mass";
  return figure;
}

}  // namespace cromer::core
