#include "cromer/report/clip.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace cromer::core {
namespace {

constexpr double slack = 0.01;  // [px] a curve that runs along the edge is seen

Box widened(const Box& b) { return {b.x - slack, b.y - slack, b.width + 2 * slack, b.height + 2 * slack}; }

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
