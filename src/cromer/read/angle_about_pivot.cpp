#include "cromer/read/angle_about_pivot.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "cromer/base/ascii.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/columns.h"

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

// The columns A and B of "angle(A,B)", in any case and with or without a unit behind it.
std::optional<std::pair<std::string_view, std::string_view>> named_in(std::string_view name) {
  constexpr std::string_view begin = "angle(";
  const std::size_t comma = name.find(','), end = name.find(')', comma == name.npos ? 0 : comma);
  if (lower(name.substr(0, begin.size())) != begin || comma == name.npos || end == name.npos)
    return std::nullopt;
  if (const std::string_view rest = trimmed(name.substr(end + 1)); !rest.empty() && rest != "(rad)")
    return std::nullopt;
  return std::pair(trimmed(name.substr(begin.size(), comma - begin.size())),
                   trimmed(name.substr(comma + 1, end - comma - 1)));
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
  constexpr double well_known = 0.02, close = 0.05, largest = 50;
  if (!(arc.radius > 0 && arc.radius < largest) || std::sqrt(squares / n) > close) return std::nullopt;
  const double variance = squares / (n - 3) * matrix.inverse()(2, 2);
  arc.radius_error = std::sqrt(std::max(0.0, variance));
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
  std::vector<double> ys = y.values;  // in the unit of x
  for (double& value : ys) value *= to_si(y).factor / to_si(x).factor;
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
      turned += 2 * std::numbers::pi * std::nearbyint((last - turned) / (2 * std::numbers::pi));
      last = turned;
    }
    angle.values.push_back(turned);
  }
  const std::size_t at = std::max(*first, *second) + 1;
  ComputedAngle computed{.table = table, .column = at, .arc = *arc, .x = *first, .y = *second};
  computed.table.columns.insert(computed.table.columns.begin() + static_cast<std::ptrdiff_t>(at),
                                std::move(angle));
  return std::optional(std::move(computed));
}

}  // namespace cromer::core
