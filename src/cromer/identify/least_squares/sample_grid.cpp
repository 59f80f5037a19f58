#include "cromer/identify/least_squares/sample_grid.h"

#include <algorithm>
#include <cmath>

#include "cromer/identify/least_squares/sampling.h"

namespace cromer::core {
namespace {

constexpr double most_places = 600;  // of a gap

}  // namespace

SampleGrid find_grid(std::span<const double> t) {
  SampleGrid grid;
  if (t.size() < 2) return grid;
  const double mean = (t.back() - t.front()) / static_cast<double>(t.size() - 1),
               longest = 1.75 * median_step(t);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 1; i < t.size(); ++i)
    if (t[i] - t[i - 1] < longest) sum += t[i] - t[i - 1], ++count;
  const bool gaps = count + 1 < t.size();
  grid.step = gaps && count > 0 ? sum / static_cast<double>(count) : mean;
  if (!gaps) return grid;
  grid.place.resize(t.size());
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double steps = std::min(std::round((t[i] - t[i - 1]) / grid.step), most_places);
    grid.place[i] = grid.place[i - 1] + static_cast<std::size_t>(std::max(1.0, steps));
  }
  return grid;
}

}  // namespace cromer::core
