#include "cromer/identify/least_squares/sampling.h"

#include <algorithm>
#include <cmath>

#include "cromer/base/even_steps.h"
#include "cromer/base/quantile.h"

namespace cromer::core {

double median_step(std::span<const double> t) {
  // Equal steps to rounding: the mean is the more accurate.
  if (const EvenSteps even = even_steps(t); even.farthest < 1e-6 * even.mean) return even.mean;
  std::vector<double> steps(t.size() - 1);
  for (std::size_t i = 1; i < t.size(); ++i) steps[i - 1] = t[i] - t[i - 1];
  return upper_median(steps);
}

Sampling find_sampling(std::span<const double> t) {
  Sampling sampling;
  if (t.size() < 2) {
    if (!t.empty()) sampling.stretches.push_back({0, 1, false});
    return sampling;
  }
  const double h = sampling.step = median_step(t);
  // Printed times carry rounding of their own size, which no sensor resolves.
  const double tolerance = 1e-9 * h + 4e-16 * std::max(std::abs(t.front()), std::abs(t.back()));
  constexpr std::size_t shortest_uniform = 16;  // below it the table costs more than the samples
  for (std::size_t first = 0; first < t.size();) {
    const std::size_t longest = std::min(longest_stretch, t.size() - first);
    std::size_t count = 1;
    while (count < longest &&
           std::abs(t[first + count] - t[first] - static_cast<double>(count) * h) <= tolerance)
      ++count;
    const bool uniform = count >= shortest_uniform;
    const bool joins = !uniform && !sampling.stretches.empty() && !sampling.stretches.back().uniform &&
                       sampling.stretches.back().count + count <= longest_stretch;
    if (joins)
      sampling.stretches.back().count += count;
    else
      sampling.stretches.push_back({first, count, uniform});
    first += count;
  }
  return sampling;
}

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
  grid.step = gaps ? sum / static_cast<double>(count) : mean;
  if (!gaps) return grid;
  grid.place.resize(t.size());
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double steps = std::min(std::round((t[i] - t[i - 1]) / grid.step), most_places);
    grid.place[i] = grid.place[i - 1] + static_cast<std::size_t>(std::max(1.0, steps));
  }
  return grid;
}

}  // namespace cromer::core
