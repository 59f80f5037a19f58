#include "cromer/identify/least_squares/rounding_bias.h"
#include "cromer/base/pi.h"

#include <algorithm>
#include <cmath>

namespace cromer::core {

double expected_rounding_error(double value, double noise) {
  if (noise < 0.05) return std::round(value) - value;
  double sum = 0;
  for (int k = 1; k < 20; ++k) {
    const double blur = std::exp(-2 * pi * pi * k * k * noise * noise);
    if (blur < 1e-4) break;
    sum += (k % 2 ? -1 : 1) * std::sin(2 * pi * k * value) * blur / (pi * k);
  }
  return sum;
}

std::vector<double> rounded_motion(const Record& record, std::span<const double> residuals) {
  const double q = record.resolution;
  if (!(q > 0) || residuals.empty()) return {};
  double mean_square = 0;
  for (double r : residuals) mean_square += r * r / static_cast<double>(residuals.size());
  if (mean_square > 0.36 * q * q) return {};
  const double noise = std::sqrt(std::max(0.0, mean_square / (q * q) - 1.0 / 12));
  const double offset = record.y[0] - q * std::round(record.y[0] / q);  // of the steps from zero
  std::vector<double> rounded(residuals.size());
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    const double motion = record.y[i] - residuals[i];
    rounded[i] = motion + q * expected_rounding_error((motion - offset) / q, noise);
  }
  return rounded;
}

}  // namespace cromer::core
