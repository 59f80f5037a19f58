#include "cromer/record/dialects/steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/base/number.h"
#include "cromer/base/quantity.h"
#include "cromer/record/dialects/series_shape.h"

namespace cromer::dialects {
namespace {

/// `value` to so many significant digits.
double to_digits(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value;
  const int places = digits - 1 - static_cast<int>(std::floor(std::log10(std::fabs(value))));
  if (std::abs(places) > 300) return value;
  const double scale = std::pow(10.0, std::abs(places));  // a whole power of ten: dividing by it rounds once
  return places >= 0 ? std::nearbyint(value * scale) / scale : std::nearbyint(value / scale) * scale;
}

/// The number of fewest digits, 12 at most, within `relative` of the value.
double round_within(double value, double relative) {
  constexpr int most_digits = 12;
  for (int digits = 1; digits < most_digits; ++digits) {
    const double round = to_digits(value, digits);
    if (std::fabs(round - value) <= relative * value) return round;
  }
  return to_digits(value, most_digits);
}

/// How much later than evenly spaced the times behind step i are than those before it: medians of ten on
/// either side, which a single late sample does not move.
double lateness(std::span<const double> t, std::size_t i, double step) {
  constexpr std::size_t reach = 10;
  const auto late = [&](std::size_t from, std::size_t to) {
    std::vector<double> offsets;
    for (std::size_t k = from; k < to; ++k)
      offsets.push_back(t[k] - t[i] - (static_cast<double>(k) - static_cast<double>(i)) * step);
    return median(std::move(offsets));
  };
  return late(i + 1, std::min(i + 1 + reach, t.size())) - late(i + 1 > reach ? i + 1 - reach : 0, i + 1);
}

}  // namespace

Steps describe_steps(std::span<const double> t) {
  constexpr double gap_of_steps = 1.5, lost_of_steps = 0.5;
  Steps result;
  if (t.size() < 2) return result;
  std::vector<double> steps(t.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = t[i + 1] - t[i];
  const double step = median(steps);
  // Times that a logger summed up or a double rounded are off by a few units in the last place of the
  // largest.
  const double rounding =
      4 * std::numeric_limits<double>::epsilon() * std::max(std::fabs(t.front()), std::fabs(t.back())) / step;
  result.rate = round_within(1 / step, rounding);

  double mean = 0, squares = 0;
  for (const double h : steps) mean += h / static_cast<double>(steps.size());
  for (const double h : steps) squares += (h - mean) * (h - mean);
  const double jitter = std::sqrt(squares / static_cast<double>(steps.size())) / step;
  result.jitter = jitter > rounding ? jitter : 0;

  for (std::size_t i = 0; i < steps.size(); ++i)
    if (steps[i] > gap_of_steps * step && lateness(t, i, step) > lost_of_steps * step)
      result.gaps.push_back({t[i], steps[i]});
  return result;
}

}  // namespace cromer::dialects
