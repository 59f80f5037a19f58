#include "cromer/report/thinning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace cromer::core {
namespace {

constexpr std::size_t longest_skip = 64;  // bounds the work; more collinear points than this are rare

bool never_goes_back(std::span<const Spot> points) {
  return std::is_sorted(points.begin(), points.end(), [](const Spot& a, const Spot& b) { return a.x < b.x; });
}

std::vector<Spot> peaks_of_columns(std::span<const Spot> points) {
  std::vector<Spot> kept;
  for (std::size_t begin = 0; begin < points.size();) {
    const double column = std::floor(2 * points[begin].x);
    std::size_t end = begin + 1, low = begin, high = begin;
    for (; end < points.size() && std::floor(2 * points[end].x) == column; ++end) {
      if (points[end].y < points[low].y) low = end;
      if (points[end].y > points[high].y) high = end;
    }
    const std::set<std::size_t> chosen{begin, low, high, end - 1};
    for (const std::size_t i : chosen) kept.push_back(points[i]);
    begin = end;
  }
  return kept;
}

double distance_to_segment(Spot p, Spot a, Spot b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
  const double s = length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - s * dx, p.y - a.y - s * dy);
}

}  // namespace

std::vector<std::vector<Spot>> unbroken(std::span<const Spot> points) {
  std::vector<std::vector<Spot>> pieces;
  bool open = false;
  for (const Spot& p : points) {
    const bool finite = std::isfinite(p.x) && std::isfinite(p.y);
    if (finite && !open) pieces.emplace_back();
    if (finite) pieces.back().push_back(p);
    open = finite;
  }
  return pieces;
}

std::vector<std::size_t> extremes(std::span<const double> x, std::span<const double> y, std::size_t columns) {
  const std::size_t n = x.size();
  std::vector<std::size_t> kept;
  if (n <= 4 * columns || n == 0) {
    for (std::size_t i = 0; i < n; ++i) kept.push_back(i);
    return kept;
  }
  const double width = (x[n - 1] - x[0]) / static_cast<double>(columns);
  const auto column_of = [&](std::size_t i) { return std::floor((x[i] - x[0]) / width); };
  for (std::size_t begin = 0; begin < n;) {
    if (!std::isfinite(x[begin]) || !std::isfinite(y[begin])) {
      kept.push_back(begin++);
      continue;
    }
    std::size_t end = begin + 1, low = begin, high = begin;
    for (; end < n && std::isfinite(y[end]) && column_of(end) == column_of(begin); ++end) {
      if (y[end] < y[low]) low = end;
      if (y[end] > y[high]) high = end;
    }
    for (const std::size_t i : std::set<std::size_t>{begin, low, high, end - 1}) kept.push_back(i);
    begin = end;
  }
  return kept;
}

std::vector<Spot> thin_line(std::span<const Spot> piece, double tolerance) {
  const std::vector<Spot> points =
      never_goes_back(piece) ? peaks_of_columns(piece) : std::vector<Spot>(piece.begin(), piece.end());
  if (points.size() < 3) return points;
  std::vector<Spot> kept{points.front()};
  std::size_t last = 0;
  for (std::size_t i = 2; i < points.size(); ++i) {
    bool straight = i - last <= longest_skip;
    for (std::size_t j = last + 1; straight && j < i; ++j) {
      straight = distance_to_segment(points[j], points[last], points[i]) <= tolerance;
    }
    if (!straight) {
      last = i - 1;
      kept.push_back(points[last]);
    }
  }
  kept.push_back(points.back());
  return kept;
}

std::vector<Spot> thin_dots(std::span<const Spot> dots, double apart) {
  std::vector<Spot> kept;
  std::set<std::pair<long, long>> taken;
  for (const Spot& p : dots) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
    if (!kept.empty() && std::hypot(p.x - kept.back().x, p.y - kept.back().y) < apart) continue;
    if (taken.emplace(std::lround(4 * p.x), std::lround(4 * p.y)).second) kept.push_back(p);
  }
  return kept;
}

Band min_max_band(std::span<const Spot> points, int columns) {
  Band band;
  std::vector<Spot> sorted;
  for (const Spot& p : points) {
    if (std::isfinite(p.x) && std::isfinite(p.y)) sorted.push_back(p);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const Spot& a, const Spot& b) { return a.x < b.x; });
  if (sorted.empty()) return band;

  Band raw;
  for (std::size_t i = 0; i < sorted.size();) {
    const double column = std::floor(sorted[i].x);
    double low = sorted[i].y, high = low;
    for (; i < sorted.size() && std::floor(sorted[i].x) == column; ++i) {
      low = std::min(low, sorted[i].y);
      high = std::max(high, sorted[i].y);
    }
    raw.x.push_back(column + 0.5);
    raw.low.push_back(low);
    raw.high.push_back(high);
  }
  raw.x.front() = sorted.front().x;
  raw.x.back() = sorted.back().x;

  const std::size_t n = raw.x.size(), before = static_cast<std::size_t>(columns - 1) / 2,
                    after = static_cast<std::size_t>(columns) / 2;
  for (std::size_t i = 0; i < n; ++i) {
    // The window keeps its length at the ends, so that half a period there does not narrow the band.
    const std::size_t wanted = i > before ? i - before : 0;
    const std::size_t end = std::min(n, wanted + before + after + 1);
    const std::size_t begin = std::min(wanted, end - std::min(end, before + after + 1));
    band.x.push_back(raw.x[i]);
    band.low.push_back(*std::min_element(raw.low.begin() + static_cast<long>(begin),
                                         raw.low.begin() + static_cast<long>(end)));
    band.high.push_back(*std::max_element(raw.high.begin() + static_cast<long>(begin),
                                          raw.high.begin() + static_cast<long>(end)));
  }
  for (std::size_t i = 0; i + 1 < n; ++i) {  // joined: no gap between a column and the next
    if (band.low[i + 1] > band.high[i]) band.low[i + 1] = band.high[i];
    if (band.high[i + 1] < band.low[i]) band.high[i + 1] = band.low[i];
  }
  return band;
}

double columns_per_period(std::span<const Spot> points) {
  double low = std::numeric_limits<double>::infinity(), high = -low, sum = 0;
  double columns = 0;  // without the gaps
  std::size_t count = 0;
  const Spot* before = nullptr;
  for (const Spot& p : points) {
    const bool finite = std::isfinite(p.x) && std::isfinite(p.y);
    if (finite && before) columns += std::abs(p.x - before->x);
    before = finite ? &p : nullptr;
    if (!finite) continue;
    low = std::min(low, p.y), high = std::max(high, p.y);
    sum += p.y;
    ++count;
  }
  if (count < 3) return std::numeric_limits<double>::infinity();
  const double middle = sum / static_cast<double>(count),
               guard = 0.02 * (high - low);  // noise about the middle is no crossing
  int crossings = 0, side = 0;
  for (const Spot& p : points) {
    const int now = p.y > middle + guard ? 1 : p.y < middle - guard ? -1 : 0;
    if (now != 0 && side != 0 && now != side) ++crossings;
    if (now != 0) side = now;
  }
  return crossings < 2 ? std::numeric_limits<double>::infinity() : 2 * columns / crossings;
}

namespace {

constexpr double edge_slack = 0.01;  // [px] a curve that runs along the edge is seen

Box widened(const Box& b) {
  return {b.x - edge_slack, b.y - edge_slack, b.width + 2 * edge_slack, b.height + 2 * edge_slack};
}

using Segment = std::pair<Spot, Spot>;

/// Y.-D. Liang & B. A. Barsky, ACM Trans. Graph. 3 (1984) 1: the shares of the way between which all four
/// edges are on the right side.
std::optional<Segment> part_inside(Spot a, Spot b, const Box& frame) {
  double from = 0, to = 1;
  const auto cut = [&](double along, double room) {  // inside where along * share <= room
    if (along == 0) return room >= 0;
    const double share = room / along;
    along < 0 ? from = std::max(from, share) : to = std::min(to, share);
    return from < to;
  };
  const double dx = b.x - a.x, dy = b.y - a.y;
  if (!cut(-dx, a.x - frame.x) || !cut(dx, frame.right() - a.x) || !cut(-dy, a.y - frame.y) ||
      !cut(dy, frame.bottom() - a.y))
    return {};
  const auto at = [&](double share) { return Spot{a.x + share * dx, a.y + share * dy}; };
  return Segment{from > 0 ? at(from) : a, to < 1 ? at(to) : b};
}

}  // namespace

bool inside(Spot p, const Box& frame) {
  const Box box = widened(frame);
  return p.x >= box.x && p.x <= box.right() && p.y >= box.y && p.y <= box.bottom();
}

std::vector<std::vector<Spot>> pieces_inside(const std::vector<Spot>& line, const Box& frame) {
  const Box box = widened(frame);
  std::vector<std::vector<Spot>> pieces;
  bool goes_on = false;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto part = part_inside(line[i - 1], line[i], box);
    if (part && !goes_on) pieces.push_back({part->first});
    if (part) pieces.back().push_back(part->second);
    goes_on = part && part->second == line[i];
  }
  return pieces;
}

Band band_inside(const Band& band, const Box& frame) {
  Band seen;
  const auto at_edge = [&](double y) { return std::clamp(y, frame.y, frame.bottom()); };
  for (std::size_t i = 0; i < band.x.size(); ++i) {
    const double x = band.x[i];
    if (!std::isnan(x) && !inside({x, frame.y}, frame)) continue;
    seen.x.push_back(x);
    seen.low.push_back(at_edge(band.low[i]));
    seen.high.push_back(at_edge(band.high[i]));
  }
  return seen;
}

}  // namespace cromer::core
