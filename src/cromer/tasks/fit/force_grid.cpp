#include "cromer/tasks/fit/force_grid.h"

#include <algorithm>
#include <cmath>

#include "cromer/base/quantity.h"

namespace cromer::core {
namespace {

constexpr double most_uneven = 0.02;  // of a sample spacing

}  // namespace

Result<ForceGrid> grid_of(const Series& force) {
  if (force.t.size() < 2) return Error{"force_is_too_short", {{"column", force.column}}};
  const auto [low, high] = std::minmax_element(force.y.begin(), force.y.end());
  if (*low == *high)
    return Error{"force_never_changes", {{"column", force.column}, {"value", shortest(*low)}}};
  if (!force.gaps.empty())
    return Error{Notice{force.gaps.size() == 1 ? "force_has_a_gap" : "force_has_gaps",
                        {{"column", force.column},
                         {"gaps", force.gaps.size()},
                         {"length", force.gaps.front().length},
                         {"t", force.gaps.front().t}}}};
  ForceGrid grid{force.t.front(),
                 (force.t.back() - force.t.front()) / static_cast<double>(force.t.size() - 1),
                 force.t.size()};
  for (std::size_t i = 0; i < grid.size; ++i)
    if (std::abs(force.t[i] - grid.time(i)) > most_uneven * grid.spacing)
      return Error{"force_is_uneven",
                   {{"line", i < force.lines.size() ? force.lines[i] : 0},
                    {"t", force.t[i]},
                    {"expected", grid.time(i)},
                    {"spacing", grid.spacing}}};
  return grid;
}

Series force_around(const Series& force, double from, double to) {
  constexpr double margin = 64;  // [samples]
  const double reach = force.rate > 0 ? margin / force.rate : 0;
  auto first = std::lower_bound(force.t.begin(), force.t.end(), from - reach) - force.t.begin();
  auto last = std::upper_bound(force.t.begin(), force.t.end(), to + reach) - force.t.begin();
  for (const Gap& gap : force.gaps) {
    const auto after = std::upper_bound(force.t.begin(), force.t.end(), gap.t) - force.t.begin();
    if (gap.t < from) first = std::max(first, after);
    if (gap.t >= to) last = std::min(last, after);
  }
  Series part = force;
  part.t.assign(force.t.begin() + first, force.t.begin() + last);
  part.y.assign(force.y.begin() + first, force.y.begin() + last);
  part.lines.assign(force.lines.begin() + first, force.lines.begin() + last);
  std::erase_if(part.gaps, [&](const Gap& gap) { return gap.t < from || gap.t >= to; });
  return part;
}

Result<std::vector<std::size_t>> places_on(const ForceGrid& grid, const Series& motion, const Series& force) {
  std::vector<std::size_t> places;
  places.reserve(motion.t.size());
  for (std::size_t i = 0; i < motion.t.size(); ++i) {
    const double at = (motion.t[i] - grid.begin) / grid.spacing, place = std::round(at);
    if (place < 0 || place >= static_cast<double>(grid.size))
      return Error{"force_ends",
                   {{"force", force.column},
                    {"from", grid.begin},
                    {"to", grid.time(grid.size - 1)},
                    {"column", motion.column},
                    {"t", motion.t[i]}}};
    if (std::abs(at - place) > most_uneven)
      return Error{"force_at_other_times",
                   {{"force", force.column}, {"column", motion.column}, {"t", motion.t[i]}}};
    places.push_back(static_cast<std::size_t>(place));
  }
  return places;
}

}  // namespace cromer::core
