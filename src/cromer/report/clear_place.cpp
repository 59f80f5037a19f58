#include "cromer/report/clear_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cromer::core {
namespace {

constexpr double leader_from = 14;     // a word this far from its point gets a leader line [px]
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
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const int steps = std::isfinite(length) ? std::min(2000, static_cast<int>(length / 3)) : 0;
    for (int k = 0; k <= steps; ++k) {
      const double s = static_cast<double>(k) / (steps + 1);
      see(steps == 0 ? a : Spot{a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)});
    }
  }
}

double distance(const std::vector<Spot>& curve, const Box& box) {
  double least = std::numeric_limits<double>::infinity();
  walk(curve, [&](Spot p) {
    const Spot edge = box.nearest(p);
    least = std::min(least, std::hypot(edge.x - p.x, edge.y - p.y));
  });
  return least;
}

bool is_clear(const Drawn& drawn, const FreePlace& place, std::size_t own) {
  const Box& box = place.box;
  if (drawn.inked.taken({box.x - 2, box.y - 2, box.width + 4, box.height + 4}) > 0) return false;
  const Spot edge = box.nearest(place.target);
  const double length = std::hypot(edge.x - place.target.x, edge.y - place.target.y);
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

/// Those of `spots` that no other curve comes near.
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
