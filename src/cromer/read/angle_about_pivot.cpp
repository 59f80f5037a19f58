#include "cromer/read/angle_about_pivot.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "cromer/base/ascii.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantile.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/columns.h"
#include "cromer/read/time.h"

namespace cromer::core {
namespace {

struct Point {
  double x, y;
};

std::vector<Point> points_of(std::span<const double> x, std::span<const double> y) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
    if (std::isfinite(x[i]) && std::isfinite(y[i])) points.push_back({x[i], y[i]});
  return points;
}

// Of points about (0, 0) with a spread of 1: the circle whose equation x² + y² = 2 a x + 2 b y + c they fit
// best, where the search begins.
Arc algebraic_arc(const std::vector<Point>& points) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const auto& [x, y] : points) {
    const Eigen::Vector3d row(2 * x, 2 * y, 1);
    matrix += row * row.transpose();
    right += row * (x * x + y * y);
  }
  const Eigen::Vector3d p = matrix.ldlt().solve(right);
  return {p[0], p[1], std::sqrt(std::max(0.0, p[2] + p[0] * p[0] + p[1] * p[1])), 0};
}

// Least squares of the distances; the matrix of their normal equations is left in `matrix`.
Arc geometric_arc(Arc arc, const std::vector<Point>& points, Eigen::Matrix3d& matrix, double& squares) {
  constexpr int most = 50;
  constexpr double settled = 1e-12;  // of the radius
  for (int i = 0; i < most; ++i) {
    matrix.setZero();
    squares = 0;
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const auto& [x, y] : points) {
      const double dx = x - arc.x, dy = y - arc.y, distance = std::hypot(dx, dy);
      if (distance == 0) return {};
      const Eigen::Vector3d row(dx / distance, dy / distance, 1);
      const double off = distance - arc.radius;
      matrix += row * row.transpose();
      right += row * off;
      squares += off * off;
    }
    const Eigen::Vector3d change = matrix.ldlt().solve(right);
    if (!change.allFinite()) return {};
    arc.x += change[0], arc.y += change[1], arc.radius += change[2];
    if (change.norm() < settled * std::abs(arc.radius)) return arc;
  }
  return {};
}

std::vector<double> distances_from(const Arc& arc, const std::vector<Point>& points) {
  std::vector<double> off;
  for (const auto& [x, y] : points) off.push_back(std::hypot(x - arc.x, y - arc.y) - arc.radius);
  return off;
}

// By how much noise that hangs together from point to point widens a variance.
double widening(const std::vector<double>& noise) {
  double squares = 0, products = 0;
  for (std::size_t i = 0; i < noise.size(); ++i) {
    squares += noise[i] * noise[i];
    if (i > 0) products += noise[i] * noise[i - 1];
  }
  const double by_chance = 2 / std::sqrt(static_cast<double>(noise.size()));
  const double rho = squares > 0 ? std::min(products / squares, 0.99) : 0;
  return rho > by_chance ? (1 + rho) / (1 - rho) : 1;
}

// The columns A and B of "angle(A,B)", in any case and with or without a unit behind it.
std::optional<std::pair<std::string_view, std::string_view>> named_in(std::string_view name) {
  constexpr std::string_view begin = "angle(", unit = "(rad)";
  name = trimmed(name);
  if (name.ends_with(unit)) name = trimmed(name.substr(0, name.size() - unit.size()));
  if (lower(name.substr(0, begin.size())) != begin || !name.ends_with(')')) return std::nullopt;
  name = name.substr(begin.size(), name.size() - begin.size() - 1);
  const std::size_t comma = name.find(',');
  if (comma == name.npos) return std::nullopt;
  return std::pair(trimmed(name.substr(0, comma)), trimmed(name.substr(comma + 1)));
}

}  // namespace

std::optional<Arc> find_arc(std::span<const double> x, std::span<const double> y) {
  std::vector<Point> points = points_of(x, y);
  constexpr std::size_t fewest = 16;
  if (points.size() < fewest) return std::nullopt;
  const auto n = static_cast<double>(points.size());
  Point mean{0, 0};
  for (const auto& [px, py] : points) mean.x += px / n, mean.y += py / n;
  double spread = 0;
  for (const auto& [px, py] : points) spread += std::pow(px - mean.x, 2) + std::pow(py - mean.y, 2);
  spread = std::sqrt(spread / n);
  // Of one place rounding alone is left.
  if (!(spread > 1e-9 * std::hypot(mean.x, mean.y)) || !std::isfinite(spread)) return std::nullopt;
  for (Point& point : points) point = {(point.x - mean.x) / spread, (point.y - mean.y) / spread};

  Eigen::Matrix3d matrix;
  double squares = 0;
  Arc arc = geometric_arc(algebraic_arc(points), points, matrix, squares);
  // A tracker may jump to something else for some frames.
  constexpr double far = 6, most_aside = 0.1;  // robust standard deviations; of the points
  const std::size_t least = points.size() - static_cast<std::size_t>(most_aside * n);
  for (bool any = true; any && arc.radius > 0;) {
    const std::vector<double> off = distances_from(arc, points);
    std::vector<double> sizes;
    for (const double each : off) sizes.push_back(std::abs(each));
    const double limit = far * 1.4826 * median(sizes);
    std::vector<Point> near;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (sizes[i] <= limit) near.push_back(points[i]);
    any = near.size() < points.size() && near.size() >= least;
    if (any) arc = geometric_arc(arc, points = std::move(near), matrix, squares);
  }
  constexpr double well_known = 0.05, close = 0.05, largest = 50;
  const auto used = static_cast<double>(points.size());
  if (!(arc.radius > 0 && arc.radius < largest) || std::sqrt(squares / used) > close) return std::nullopt;
  const double variance = squares / (used - 3) * matrix.inverse()(2, 2);
  arc.radius_error = std::sqrt(std::max(0.0, variance) * widening(distances_from(arc, points)));
  if (!(arc.radius_error < well_known * arc.radius)) return std::nullopt;
  return Arc{mean.x + spread * arc.x, mean.y + spread * arc.y, spread * arc.radius,
             spread * arc.radius_error};
}

std::string name_of_angle(const Column& x, const Column& y) { return "angle(" + x.name + "," + y.name + ")"; }

Result<std::optional<ComputedAngle>> computed_angle(const Table& table, std::string_view name, int run) {
  const auto named = named_in(name);
  if (!named) return std::optional<ComputedAngle>{};
  const auto first = find_column(table, named->first, run), second = find_column(table, named->second, run);
  if (!first) return first.error();
  if (!second) return second.error();
  const Column &x = table.columns[*first], &y = table.columns[*second];
  if (x.quantity != y.quantity || x.quantity == "time" ||
      dialects::time_column_of(table, *first) != dialects::time_column_of(table, *second))
    return Error{"no_one_point", {{"x", x.name}, {"y", y.name}}};
  const double in_unit_of_x = to_si(y).factor / to_si(x).factor;
  std::vector<double> ys = y.values;
  for (double& value : ys) value *= in_unit_of_x;
  const std::optional<Arc> arc = find_arc(x.values, ys);
  if (!arc) return Error{"no_arc", {{"x", x.name}, {"y", y.name}}};

  // From the direction of the middle, which the swing passes.
  Column angle{.name = name_of_angle(x, y), .quantity = "angle", .unit = "rad", .run = x.run, .values = {}};
  double along = 0, across = 0;
  for (const auto& [px, py] : points_of(x.values, ys)) along += px - arc->x, across += py - arc->y;
  const double to_larger_x = across > 0 ? -1 : 1;
  double last = 0;
  for (std::size_t i = 0; i < x.values.size(); ++i) {
    const double dx = x.values[i] - arc->x, dy = ys[i] - arc->y;
    double turned = to_larger_x * std::atan2(along * dy - across * dx, along * dx + across * dy);
    // Over the top it goes on.
    if (std::isfinite(turned)) {
      turned += two_pi * std::nearbyint((last - turned) / two_pi);
      last = turned;
    }
    angle.values.push_back(turned);
  }
  return std::optional(ComputedAngle{.angle = std::move(angle),
                                     .place = std::max(*first, *second) + 1,
                                     .arc = *arc,
                                     .x = *first,
                                     .y = *second});
}

}  // namespace cromer::core
