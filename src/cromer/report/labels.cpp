#include "cromer/report/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace cromer::core {
namespace {

constexpr double cell = 2;         // [px]
constexpr double clearance = 4;    // between a word and what is drawn [px]
constexpr double search_step = 4;  // [px]

}  // namespace

Spot Box::nearest(Spot p) const { return {std::clamp(p.x, x, right()), std::clamp(p.y, y, bottom())}; }

std::vector<double> spread(std::span<const double> centres, std::span<const double> heights,
                           std::span<const double> gaps, double top, double bottom) {
  const std::size_t n = centres.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return centres[a] < centres[b]; });

  // Groups of touching intervals, each at the mean of what its members ask for: pool adjacent violators.
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
      columns_(static_cast<int>(frame.width / cell) + 2),
      rows_(static_cast<int>(frame.height / cell) + 2),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void Occupancy::mark(double x, double y) {
  const int column = static_cast<int>((x - frame_.x) / cell), row = static_cast<int>((y - frame_.y) / cell);
  if (x < frame_.x || y < frame_.y || column >= columns_ || row >= rows_) return;
  cells_[static_cast<std::size_t>(row * columns_ + column)] = 1;
}

bool Occupancy::is_taken(double x, double y) const {
  const int column = static_cast<int>((x - frame_.x) / cell), row = static_cast<int>((y - frame_.y) / cell);
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
  for (double y = box.y; y <= box.bottom(); y += cell) {
    for (double x = box.x; x <= box.right(); x += cell) mark(x, y);
  }
}

int Occupancy::taken(const Box& box) const {
  int count = 0;
  for (double y = box.y; y <= box.bottom(); y += cell) {
    for (double x = box.x; x <= box.right(); x += cell) count += is_taken(x, y);
  }
  return count;
}

int Occupancy::crossed(Spot from, Spot to) const {
  const int steps = static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / cell) + 1;
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
      double distance = targets.empty() ? 0 : std::numeric_limits<double>::infinity();
      for (const Spot& t : targets) {
        const Spot edge = box.nearest(t);
        const double d = std::hypot(edge.x - t.x, edge.y - t.y);
        if (d < distance) distance = d, target = t;
      }
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

}  // namespace cromer::core
