#include "cromer/base/quantile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "cromer/base/extent.h"

namespace cromer::core {
namespace {

constexpr std::size_t bins = 1024;   // of equal width, from the lowest value to the highest
constexpr std::size_t fewest = 512;  // values; it does not pay to count less

double by_order(std::span<double> values, std::size_t place) {
  const auto there = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), there, values.end());
  return *there;
}

/// The value at this place of the sorted ones. Only those in its bin are put in order: that takes a quarter
/// of the time where the values are spread out, and hardly more than by_order where one bin has them all.
double at_place(std::span<double> values, std::size_t place) {
  if (values.size() < fewest) return by_order(values, place);
  const auto [lowest, highest] = extent_of(values);
  const double width = highest - lowest, scale = (bins - 1) / width;
  if (!std::isfinite(width) || !std::isfinite(scale)) return by_order(values, place);
  const auto bin_of = [low = lowest, scale](double value) {
    const double number = (value - low) * scale;
    return number < bins ? static_cast<std::size_t>(number) : 0;  // NaN in any
  };
  std::array<std::size_t, bins> count{};
  for (const double value : values) ++count[bin_of(value)];
  std::size_t chosen = 0, below = 0;
  while (below + count[chosen] <= place) below += count[chosen++];
  std::vector<double> within(count[chosen] + 1);  // one place more to write what is not kept
  std::size_t kept = 0;
  for (const double value : values) {
    within[kept] = value;
    kept += bin_of(value) == chosen;
  }
  return by_order(std::span(within).first(kept), place - below);
}

}  // namespace

double quantile(std::span<double> values, double share) {
  return at_place(values, static_cast<std::size_t>(share * static_cast<double>(values.size())));
}

double upper_median(std::span<double> values) { return quantile(values, 0.5); }

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double upper = upper_median(values);
  if (values.size() % 2 == 1) return upper;
  // The lower of the two is the largest of those below, unless both are equal.
  std::size_t less = 0;
  double lower = -std::numeric_limits<double>::infinity();
  for (const double value : values) {
    less += value < upper;
    lower = value < upper ? std::max(lower, value) : lower;
  }
  return less == values.size() / 2 ? (upper + lower) / 2 : upper;
}

}  // namespace cromer::core
