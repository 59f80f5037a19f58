#include "cromer/report/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace cromer::core {
namespace {

constexpr double raster = 2;       // [px]
constexpr double clearance = 4;    // between a word and what is drawn [px]
constexpr double search_step = 4;  // [px]

// Squares do where many distances are compared.
double squared_distance(Spot a, Spot b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return dx * dx + dy * dy;
}

}  // namespace

std::vector<double> spread(std::span<const double> centres, std::span<const double> heights,
                           std::span<const double> gaps, double top, double bottom) {
  const std::size_t n = centres.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return centres[a] < centres[b]; });

  // Pool adjacent violators: each group of touching intervals stands at the mean of its members' wishes.
  struct Group {
    double offset_sum, length;  // sum over members of wanted start minus place in the group
    int members;
    double start(double low, double high) const {
      return std::max(low, std::min(offset_sum / members, high - length));
    }
  };
  std::vector<Group> groups;
  for (const std::size_t i : order) {
    groups.push_back({centres[i] - heights[i] / 2, heights[i] + gaps[i], 1});
    while (groups.size() > 1) {
      const Group& last = groups.back();
      Group& before = groups[groups.size() - 2];
      if (before.start(top, bottom) + before.length <= last.start(top, bottom)) break;
      before.offset_sum += last.offset_sum - before.length * last.members;
      before.length += last.length;
      before.members += last.members;
      groups.pop_back();
    }
  }
  std::vector<double> placed(n);
  std::size_t k = 0;
  for (const Group& group : groups) {
    double y = group.start(top, bottom);
    for (int j = 0; j < group.members; ++j, ++k) {
      const std::size_t i = order[k];
      placed[i] = y + heights[i] / 2;
      y += heights[i] + gaps[i];
    }
  }
  return placed;
}

Occupancy::Occupancy(Box frame)
    : frame_(frame),
      columns_(static_cast<int>(frame.width / raster) + 2),
      rows_(static_cast<int>(frame.height / raster) + 2),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void Occupancy::mark(double x, double y) {
  const int column = static_cast<int>((x - frame_.x) / raster),
            row = static_cast<int>((y - frame_.y) / raster);
  if (x < frame_.x || y < frame_.y || column >= columns_ || row >= rows_) return;
  cells_[static_cast<std::size_t>(row * columns_ + column)] = 1;
}

bool Occupancy::is_taken(double x, double y) const {
  const int column = static_cast<int>((x - frame_.x) / raster),
            row = static_cast<int>((y - frame_.y) / raster);
  if (x < frame_.x || y < frame_.y || column >= columns_ || row >= rows_) return false;
  return cells_[static_cast<std::size_t>(row * columns_ + column)] != 0;
}

void Occupancy::add_line(std::span<const Spot> points, double width) {
  const Box near{frame_.x - 50, frame_.y - 50, frame_.width + 100, frame_.height + 100};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Spot a = near.nearest(points[i]), b = near.nearest(points[std::min(i + 1, points.size() - 1)]);
    const int steps = static_cast<int>(std::hypot(b.x - a.x, b.y - a.y)) + 1;
    for (int k = 0; k <= steps; ++k) {
      const double s = static_cast<double>(k) / steps, x = a.x + s * (b.x - a.x), y = a.y + s * (b.y - a.y);
      mark(x, y);
      if (width > 2)
        mark(x - width / 2, y), mark(x + width / 2, y), mark(x, y - width / 2), mark(x, y + width / 2);
    }
  }
}

void Occupancy::add_box(const Box& box) {
  for (double y = box.y; y <= box.bottom(); y += raster) {
    for (double x = box.x; x <= box.right(); x += raster) mark(x, y);
  }
}

int Occupancy::taken(const Box& box) const {
  // First and last cell of `all` that a length from here covers.
  const auto cells_along = [](double from, double length, int all) {
    const int first = static_cast<int>(std::floor(from / raster));
    return std::pair(std::max(first, 0), std::min(first + static_cast<int>(length / raster), all - 1));
  };
  const auto [left, right] = cells_along(box.x - frame_.x, box.width, columns_);
  const auto [top, bottom] = cells_along(box.y - frame_.y, box.height, rows_);
  int count = 0;
  for (int row = top; row <= bottom; ++row)
    for (int column = left; column <= right; ++column)
      count += cells_[static_cast<std::size_t>(row * columns_ + column)];
  return count;
}

int Occupancy::crossed(Spot from, Spot to) const {
  const int steps = static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / raster) + 1;
  int count = 0;
  for (int k = 0; k <= steps; ++k) {
    const double s = static_cast<double>(k) / steps;
    count += is_taken(from.x + s * (to.x - from.x), from.y + s * (to.y - from.y));
  }
  return count;
}

FreePlace free_place(const Occupancy& drawn, const Box& frame, double width, double height,
                     std::span<const Spot> targets) {
  FreePlace best;
  double lowest_cost = std::numeric_limits<double>::infinity();
  for (double y = frame.y + 2; y + height <= frame.bottom() - 2; y += search_step) {
    for (double x = frame.x + 6; x + width <= frame.right() - 2; x += search_step) {
      const Box box{x, y, width, height};
      const int covered =
          drawn.taken({x - clearance, y - clearance, width + 2 * clearance, height + 2 * clearance});
      if (10.0 * covered >= lowest_cost) continue;
      Spot target{x, y + height / 2};
      double least = targets.empty() ? 0 : std::numeric_limits<double>::infinity();
      for (const Spot& t : targets) {
        const double d = squared_distance(box.nearest(t), t);
        if (d < least) least = d, target = t;
      }
      const double distance = std::sqrt(least);
      const double crossings = distance > 14 ? drawn.crossed(box.nearest(target), target) : 0;
      const double cost = 10.0 * covered + distance + 3 * crossings;
      if (cost < lowest_cost) {
        lowest_cost = cost;
        best = {box, target, distance, covered};
      }
    }
  }
  if (!std::isfinite(lowest_cost))
    best.box = {frame.x + 4, frame.y + 4, width, height};  // wider than the panel: the corner
  return best;
}

namespace {

constexpr double longest_leader = 90;  // [px]
constexpr double short_of_curve = 6;   // a leader line ends at a curve: so much of it is not looked at [px]
constexpr double apart = 8;            // a point is read off where other curves are this far [px]
constexpr double closer = 4;           // to its own curve than to another [px]

/// Calls `see` with places along the line, 3 px from each other at most.
template <class See>
void walk(const std::vector<Spot>& spots, const See& see) {
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const Spot a = spots[i];
    if (!std::isfinite(a.x) || !std::isfinite(a.y)) continue;
    const Spot b = i + 1 < spots.size() ? spots[i + 1] : a;
    const double length = std::sqrt(squared_distance(a, b));
    see(a);
    if (length < 3 || !std::isfinite(length)) continue;
    const int steps = std::min(2000, static_cast<int>(length / 3));
    for (int k = 1; k <= steps; ++k) {
      const double s = static_cast<double>(k) / (steps + 1);
      see({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)});
    }
  }
}

double distance(const std::vector<Spot>& curve, const Box& box) {
  double least = std::numeric_limits<double>::infinity();
  walk(curve, [&](Spot p) { least = std::min(least, squared_distance(box.nearest(p), p)); });
  return std::sqrt(least);
}

bool is_clear(const Drawn& drawn, const FreePlace& place, std::size_t own) {
  const Box& box = place.box;
  if (drawn.inked.taken({box.x - 2, box.y - 2, box.width + 4, box.height + 4}) > 0) return false;
  const Spot edge = box.nearest(place.target);
  const double length = std::sqrt(squared_distance(edge, place.target));
  if (length >= leader_from) {
    if (length > longest_leader) return false;
    const double share = (length - short_of_curve) / length;
    const Spot end{edge.x + share * (place.target.x - edge.x), edge.y + share * (place.target.y - edge.y)};
    return drawn.inked.crossed(edge, end) == 0;
  }
  const double mine = distance(drawn.curves[own], box);
  for (std::size_t i = 0; i < drawn.curves.size(); ++i)
    if (i != own && distance(drawn.curves[i], box) < mine + closer) return false;
  return true;
}

/// The `spots` that no other curve comes near.
std::vector<Spot> standing_apart(const Drawn& drawn, std::span<const Spot> spots, std::size_t own) {
  std::vector<Spot> alone;
  for (const Spot& p : spots) {
    const Box point{p.x, p.y, 0, 0};
    bool near = false;
    for (std::size_t i = 0; i < drawn.curves.size() && !near; ++i)
      near = i != own && distance(drawn.curves[i], point) < apart;
    if (!near) alone.push_back(p);
  }
  return alone;
}

}  // namespace

ClearPlace clear_place(const Drawn& drawn, const Box& frame, double width, double height, std::size_t own,
                       std::span<const Spot> wanted, std::span<const Spot> anywhere) {
  ClearPlace first;
  first.place = free_place(drawn.all, frame, width, height, wanted);
  first.clear = is_clear(drawn, first.place, own);
  if (first.clear) return first;
  const std::vector<Spot> alone = standing_apart(drawn, anywhere, own);
  if (alone.empty()) return first;
  for (const Occupancy* kept_clear : {&drawn.all, &drawn.inked}) {
    const FreePlace place = free_place(*kept_clear, frame, width, height, alone);
    if (is_clear(drawn, place, own)) return {place, true};
  }
  return first;
}

}  // namespace cromer::core
