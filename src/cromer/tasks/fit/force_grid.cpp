#include "cromer/tasks/fit/force_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/base/quantity.h"

namespace cromer::core {
namespace {

constexpr double most_uneven = 0.02;  // of a sample spacing

}  // namespace

Result<ForceGrid> grid_of(const Series& force) {
  const auto column = [&] { return fmt::format("force column \"{}\"", force.column); };
  if (force.t.size() < 2) return Error{column() + " has fewer than two values"};
  const auto [low, high] = std::minmax_element(force.y.begin(), force.y.end());
  if (*low == *high)
    return Error{
        fmt::format("{} is {} throughout: a force that never changes drives nothing; leave out "
                    "--force-column to fit the free motion",
                    column(), shortest(*low))};
  if (!force.gaps.empty())
    return Error{
        fmt::format("{} has {}, the first {:.6g} s long at {:.6g} s: what the force did there is not known; "
                    "choose one side of it with --from and --to, or fill it in",
                    column(), force.gaps.size() == 1 ? "a gap" : fmt::format("{} gaps", force.gaps.size()),
                    force.gaps.front().length, force.gaps.front().t)};
  ForceGrid grid{force.t.front(),
                 (force.t.back() - force.t.front()) / static_cast<double>(force.t.size() - 1),
                 force.t.size()};
  for (std::size_t i = 0; i < grid.size; ++i)
    if (std::abs(force.t[i] - grid.time(i)) > most_uneven * grid.spacing)
      return Error{fmt::format(
          "line {}: the times are not evenly spaced ({:.6g} s where {:.6g} s is expected, one sample each "
          "{:.6g} s); a recorded force needs even samples: resample the recording first",
          i < force.lines.size() ? force.lines[i] : 0, force.t[i], grid.time(i), grid.spacing)};
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
      return Error{fmt::format(
          "force column \"{}\" goes from {:.6g} to {:.6g} s, and column \"{}\" has a value at {:.6g} s; "
          "choose the part that both have with --from and --to",
          force.column, grid.begin, grid.time(grid.size - 1), motion.column, motion.t[i])};
    if (std::abs(at - place) > most_uneven)
      return Error{
          fmt::format("force column \"{}\" has other times than column \"{}\": {:.9g} s lies between "
                      "two of its samples; resample one of them first",
                      force.column, motion.column, motion.t[i])};
    places.push_back(static_cast<std::size_t>(place));
  }
  return places;
}

}  // namespace cromer::core
