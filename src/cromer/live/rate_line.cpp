#include "cromer/live/rate_line.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cromer/base/quantile.h"

namespace cromer::core {
namespace {

constexpr double shortest_memory = 2;   // [s] where there is more
constexpr double least_period = 5e-5;   // [s]
constexpr double good_arrival = 3e-4;   // [s]
constexpr double largest_change = 0.1;  // [s] that counts

/// The number of samples in so many seconds, two at least.
std::size_t samples_in(double seconds, std::span<const double> arrivals) {
  const double period = (arrivals.back() - arrivals.front()) / static_cast<double>(arrivals.size() - 1);
  return static_cast<std::size_t>(std::clamp(period > 0 ? seconds / period : 0, 2.0, 1e6));
}

/// The least delay in each piece of so many samples. Samples left over at the front make no piece.
std::vector<double> least_delays(std::span<const double> arrivals, const RateLine& line, std::size_t piece) {
  std::vector<double> least;
  for (std::size_t begin = arrivals.size() % piece; begin < arrivals.size(); begin += piece) {
    double smallest = arrivals[begin] - line.at(static_cast<double>(begin));
    for (std::size_t i = begin + 1; i < begin + piece; ++i)
      smallest = std::min(smallest, arrivals[i] - line.at(static_cast<double>(i)));
    least.push_back(smallest);
  }
  return least;
}

/// The quantile of some delays; 0 if there are none.
double delay_at(double share, std::vector<double> delays) {
  return delays.empty() ? 0 : quantile(delays, share);
}

}  // namespace

RateLine line_below(std::span<const double> arrivals) {
  const auto above = [&](std::size_t a, std::size_t b, std::size_t c) {
    const double run_b = static_cast<double>(b - a), run_c = static_cast<double>(c - a);
    return (arrivals[b] - arrivals[a]) * run_c >= (arrivals[c] - arrivals[a]) * run_b;
  };
  std::vector<std::size_t> hull;
  for (std::size_t i = 0; i < arrivals.size(); ++i) {
    while (hull.size() > 1 && above(hull[hull.size() - 2], hull.back(), i)) hull.pop_back();
    hull.push_back(i);
  }
  const std::size_t middle = (arrivals.size() - 1) / 2;
  const auto end = std::upper_bound(hull.begin() + 1, hull.end() - 1, middle);
  const auto a = *(end - 1), b = *end;
  const double period = (arrivals[b] - arrivals[a]) / static_cast<double>(b - a);
  return {arrivals[a] - static_cast<double>(a) * period, period};
}

double roughness(std::span<const double> arrivals) {
  if (arrivals.size() < 3) return 0;
  double sum = 0;
  for (std::size_t i = 1; i + 1 < arrivals.size(); ++i)
    sum += std::min(largest_change, std::abs(arrivals[i + 1] - 2 * arrivals[i] + arrivals[i - 1]));
  return sum / static_cast<double>(arrivals.size() - 2);
}

double lateness(std::span<const double> arrivals, const RateLine& line) {
  return delay_at(0.9, least_delays(arrivals, line, samples_in(0.2, arrivals)));
}

// Pieces of a tenth of a second are short beside a swing: some sensors' interval follows the distance. Longer
// pieces find a rate that wanders.
bool is_touched(std::span<const double> arrivals, const RateLine& line) {
  const std::vector<double> all = least_delays(arrivals, line, samples_in(0.1, arrivals));
  const std::vector<double> recent(all.end() - static_cast<std::ptrdiff_t>((all.size() + 3) / 4), all.end());
  const double bound = std::max(good_arrival, 0.7 * roughness(arrivals));
  return delay_at(0.4, all) <= bound && delay_at(0.4, recent) <= bound &&
         delay_at(0.75, least_delays(arrivals, line, samples_in(0.8, arrivals))) <= bound;
}

std::optional<RateLine> steady_rate(std::span<const double> arrivals, double least) {
  std::size_t skipped = 0;
  for (double memory = longest_memory; memory >= shortest_memory; memory /= 2) {
    if (arrivals.size() < least_samples || arrivals.back() - arrivals.front() < least) break;
    const auto from = static_cast<std::size_t>(
        std::lower_bound(arrivals.begin(), arrivals.end(), arrivals.back() - memory) - arrivals.begin());
    const std::size_t begin = std::min(from, arrivals.size() - least_samples);
    arrivals = arrivals.subspan(begin);
    skipped += begin;
    const RateLine line = line_below(arrivals);
    if (line.period >= least_period && is_touched(arrivals, line))
      return RateLine{line.at(-static_cast<double>(skipped)), line.period};
    if (arrivals.size() == least_samples) break;
  }
  return std::nullopt;
}

}  // namespace cromer::core
