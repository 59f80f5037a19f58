#include "cromer/tasks/inspect/axis_swing.h"

#include <algorithm>

#include "cromer/analysis/spectrum.h"
#include "cromer/base/extent.h"

namespace cromer::core {

AxisSwing swing_in(std::span<const double> t, std::span<const double> y, double rate) {
  const auto [low, high] = extent_of(y);
  // Times far apart would make the spectrum endless.
  constexpr double sparsest = 100;  // mean step over the nominal one
  if (y.size() < 4 || low == high || !(rate > 0)) return {};
  if (!((t.back() - t.front()) * rate < sparsest * static_cast<double>(y.size()))) return {};
  const auto line = strongest_line(least_squares_spectrum(t, y, 1 / rate));
  if (!line) return {};
  double mean = 0, variance = 0;
  for (const double each : y) mean += each / static_cast<double>(y.size());
  for (const double each : y) variance += (each - mean) * (each - mean) / static_cast<double>(y.size());
  return {line->amplitude, std::min(1.0, 0.5 * line->amplitude * line->amplitude / variance),
          line->angular_frequency};
}

}  // namespace cromer::core
