#include "cromer/identify/diagnose/drop_outs.h"

#include <algorithm>
#include <cmath>

namespace cromer::core {
namespace {

// So many values tell a quantile to a hundredth of the whole and better.
constexpr std::size_t enough_values = 200'000;

double quantile(std::vector<double>& values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

std::vector<std::size_t> drop_outs(const Record& record) {
  const std::span<const double> y = record.y;
  const std::size_t n = y.size();
  if (n < 32) return {};
  const std::size_t stride = (n + enough_values - 1) / enough_values;
  std::vector<double> values, changes;
  for (std::size_t i = 0; i + 1 < n; i += stride) {
    values.push_back(y[i]);
    changes.push_back(std::abs(y[i + 1] - y[i]));
  }
  // Drop-outs may be more than 1 % of the values: 5 % and 95 % reach no further than the motion.
  const double low = quantile(values, 0.05), high = quantile(values, 0.95);
  const double width = high - low,
               jump = std::max({0.5 * width, 4 * quantile(changes, 0.95), 4 * record.resolution});

  std::vector<std::size_t> found;
  for (std::size_t first = 0; first < n;) {
    std::size_t last = first + 1;
    while (last < n && y[last] == y[first]) ++last;
    const double value = y[first], side = value < low ? -1 : 1;
    const bool outside = value < low - width || value > high + width;
    // Three equal values at a turning point of the motion are left by three rounding steps at most.
    const bool reached = first == 0 || side * (value - y[first - 1]) > jump;
    const bool left = last == n || side * (value - y[last]) > jump;
    if (last - first >= 3 && outside && reached && left)
      for (std::size_t i = first; i < last; ++i) found.push_back(i);
    first = last;
  }
  if (10 * found.size() > n) found.clear();
  return found;
}

}  // namespace cromer::core
