#include "cromer/identify/record.h"

#include <cmath>

namespace cromer::core {

double centred_norm(std::span<const double> y) {
  double mean = 0, sum = 0;
  for (double value : y) mean += value;
  mean /= static_cast<double>(y.size());
  for (double value : y) sum += (value - mean) * (value - mean);
  return std::sqrt(sum);
}

double sinusoid_amplitude(std::span<const double> y) {
  return std::sqrt(2 / static_cast<double>(y.size())) * centred_norm(y);
}

double noise_of(std::span<const double> values) {
  if (values.size() < 3) return 0;
  double sum = 0;
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    const double d = values[i - 1] - 2 * values[i] + values[i + 1];
    sum += d * d;
  }
  return std::sqrt(sum / (6 * static_cast<double>(values.size() - 2)));
}

std::vector<AmplitudeWindow> amplitude_windows(const Record& record, double length, std::size_t at_least) {
  std::vector<AmplitudeWindow> windows;
  for (std::size_t first = 0;;) {
    const double end = record.t[first] + length;
    if (end > record.t.back() || !(end > record.t[first])) break;  // the latter: shorter than rounding
    std::size_t last = first;
    while (record.t[last] < end) ++last;
    if (last - first >= at_least)
      windows.push_back({record.t[first], end, sinusoid_amplitude(record.y.subspan(first, last - first))});
    first = last;
  }
  return windows;
}

}  // namespace cromer::core
