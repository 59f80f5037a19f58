#include "cromer/analysis/envelope.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace cromer::core {
namespace {

struct Point {
  double t, x;
};

/// Vertex of the parabola through three points, the middle one the outermost.
Point vertex(Point a, Point b, Point c) {
  // Newton's form about b keeps the digits when t is large.
  const double left = a.t - b.t, right = c.t - b.t;
  const double slope_left = (a.x - b.x) / left, slope_right = (c.x - b.x) / right;
  const double curvature = (slope_right - slope_left) / (right - left);
  if (curvature == 0) return b;
  const double slope = slope_left - curvature * left;
  const double shift = -slope / (2 * curvature);
  return {b.t + shift, b.x + slope * shift + curvature * shift * shift};
}

}  // namespace

Envelope envelope(std::span<const double> t, std::span<const double> x) {
  assert(t.size() == x.size());
  Envelope found;
  const std::size_t n = x.size();
  if (n < 3) return found;
  const auto add = [&](Point p, bool top) {
    (top ? found.top_t : found.bottom_t).push_back(p.t);
    (top ? found.top : found.bottom).push_back(p.x);
  };
  if (x[0] != 0 && (x[1] - x[0]) * x[0] < 0) {
    // At rest at first: the parabola turns nearer to the first sample than to the second.
    const Point turns = vertex({t[0], x[0]}, {t[1], x[1]}, {t[2], x[2]});
    if (std::abs(turns.t - t[0]) < 0.5 * (t[1] - t[0])) add({t[0], x[0]}, x[0] > 0);
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const bool top = x[i] > x[i - 1] && x[i] >= x[i + 1];
    const bool bottom = x[i] < x[i - 1] && x[i] <= x[i + 1];
    if (top || bottom) add(vertex({t[i - 1], x[i - 1]}, {t[i], x[i]}, {t[i + 1], x[i + 1]}), top);
  }
  return found;
}

double interpolate(std::span<const double> at, std::span<const double> values, double t) {
  assert(at.size() == values.size() && !at.empty());
  const auto after = std::upper_bound(at.begin(), at.end(), t);
  if (after == at.begin()) return values.front();
  if (after == at.end()) return values.back();
  const auto i = static_cast<std::size_t>(after - at.begin());
  const double share = (t - at[i - 1]) / (at[i] - at[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

}  // namespace cromer::core
