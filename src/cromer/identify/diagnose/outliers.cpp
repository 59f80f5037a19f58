#include "cromer/identify/diagnose/outliers.h"

#include <cmath>

#include "cromer/base/extent.h"
#include "cromer/base/quantile.h"
#include "cromer/identify/least_squares/noise.h"

namespace cromer::core {
namespace {

constexpr double normal = 1.4826;            // standard deviation over median absolute deviation
constexpr std::size_t neighbours = 10;       // on either side
constexpr std::size_t enough_values = 4096;  // for a scale known to 2 %

// Median and robust standard deviation.
struct Spread {
  double centre = 0, deviation = 0;
};

Spread spread_of(std::vector<double>& values) {
  Spread spread;
  spread.centre = upper_median(values);
  for (double& value : values) value = std::abs(value - spread.centre);
  spread.deviation = normal * upper_median(values);
  return spread;
}

// Of the residuals, and of what is independent from sample to sample.
Spread overall(std::span<const double> r, double& noise) {
  const std::size_t stride = (r.size() + enough_values - 1) / enough_values;
  std::vector<double> values, changes;
  for (std::size_t i = 0; i + 1 < r.size(); i += stride) {
    values.push_back(r[i]);
    changes.push_back((r[i + 1] - r[i]) / std::sqrt(2.0));
  }
  noise = spread_of(changes).deviation;
  return spread_of(values);
}

double largest_of(std::span<const double> y) {
  const auto [low, high] = extent_of(y);
  return std::max(std::abs(low), std::abs(high));
}

Spread beside(std::span<const double> r, std::size_t i) {
  const std::size_t first = i > neighbours ? i - neighbours : 0;
  std::vector<double> values;
  for (std::size_t j = first; j < std::min(r.size(), i + neighbours + 1); ++j)
    if (j != i) values.push_back(r[j]);
  return spread_of(values);
}

// Those whose residuals stand out by more than `rounding` too.
std::vector<std::size_t> standing_out(std::span<const double> r, double rounding) {
  const auto n = static_cast<double>(r.size());
  const double many = std::max(4.0, std::sqrt(2 * std::log(5 * n)));
  double noise = 0;
  const Spread all = overall(r, noise);
  const double limit = std::max(many * all.deviation, rounding);

  std::vector<std::size_t> found;
  std::size_t suspects = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (!(std::abs(r[i] - all.centre) > limit)) continue;
    if (5 * ++suspects > r.size()) return {};
    const Spread near = beside(r, i);
    const double scale = std::max(near.deviation, noise);
    if (std::abs(r[i] - near.centre) > std::max(many * scale, rounding)) found.push_back(i);
  }
  if (10 * found.size() > r.size()) found.clear();
  return found;
}

// The residuals over the scale of noise that grows with the motion; empty where it does not. What stands out
// counts no more than the largest of the others.
std::vector<double> standardised(const Record& record, std::span<const double> r,
                                 const std::vector<std::size_t>& out) {
  std::vector<double> motion, others(r.begin(), r.end());
  for (std::size_t i = 0; i < r.size(); ++i) motion.push_back(record.y[i] - r[i]);
  for (const std::size_t i : out) others[i] = 0;
  const double most = largest_of(others);
  for (const std::size_t i : out) others[i] = most;
  std::vector<double> scale = noise_scale(find_grid(record.t), others, motion);
  for (std::size_t i = 0; i < scale.size(); ++i) scale[i] = r[i] / scale[i];
  return scale;
}

}  // namespace

std::vector<std::size_t> outliers(const Record& record, std::span<const double> r) {
  constexpr std::size_t fewest = 32;
  if (r.size() < fewest) return {};
  // Rounding, by the sensor or by the arithmetic, makes no outlier.
  std::vector<std::size_t> found =
      standing_out(r, std::max(1.5 * record.resolution, 1e-6 * largest_of(record.y)));
  if (found.empty()) return found;
  if (const std::vector<double> u = standardised(record, r, found); !u.empty()) {
    const std::vector<std::size_t> still = standing_out(u, 0);
    std::erase_if(found, [&](std::size_t i) { return !std::binary_search(still.begin(), still.end(), i); });
  }
  return found;
}

KeptSamples::KeptSamples(const Record& record, const std::vector<std::size_t>& without,
                         std::span<const double> residuals)
    : like_(record) {
  t.reserve(record.t.size() - without.size());
  y.reserve(record.t.size() - without.size());
  auto next = without.begin();
  for (std::size_t i = 0; i < record.t.size(); ++i) {
    if (next != without.end() && *next == i) {
      ++next;
      if (i > 0) continue;
      t.push_back(record.t[i]);
      y.push_back(residuals.empty() ? record.y[i] : record.y[i] - residuals[i]);
      continue;
    }
    t.push_back(record.t[i]);
    y.push_back(record.y[i]);
  }
}

namespace {

// So many values tell a quantile to a hundredth of the whole and better.
constexpr std::size_t enough_for_quantiles = 200'000;

}  // namespace

std::vector<std::size_t> drop_outs(const Record& record) {
  const std::span<const double> y = record.y;
  const std::size_t n = y.size();
  if (n < 32) return {};
  // Three equal values in a row, or there is nothing to look for.
  std::size_t equal = 1;
  for (std::size_t i = 1; i < n && equal < 3; ++i) equal = y[i] == y[i - 1] ? equal + 1 : 1;
  if (equal < 3) return {};
  const std::size_t stride = (n + enough_for_quantiles - 1) / enough_for_quantiles;
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
