#include "cromer/identify/modal/modal_record.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cromer/base/quantile.h"

namespace cromer::core {

void set_times(ModalRecord& record, const std::vector<double>& t) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < t.size(); ++i) steps.push_back(t[i] - t[i - 1]);
  std::vector<double> sorted = steps;
  const double gap = 1.75 * upper_median(sorted);
  double sum = 0;
  std::size_t count = 0;
  record.starts = {0};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] > gap) {
      record.starts.push_back(i + 1);
      continue;
    }
    sum += steps[i];
    ++count;
  }
  record.step = sum / static_cast<double>(count);
  record.times = t;
}

Notice drifting_clock(const ModalRecord& record) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < record.times.size(); ++i)
    if (const double step = record.times[i] - record.times[i - 1]; step < 1.75 * record.step)
      steps.push_back(step);
  const std::size_t third = steps.size() / 3;
  if (third < 20) return {};
  const auto mean_of = [&](std::size_t from) {
    double sum = 0, square = 0;
    for (std::size_t i = from; i < from + third; ++i) sum += steps[i], square += steps[i] * steps[i];
    const double mean = sum / static_cast<double>(third);
    return std::pair{mean, std::sqrt(std::max(0.0, square / static_cast<double>(third) - mean * mean) /
                                     static_cast<double>(third))};
  };
  const auto [first, first_error] = mean_of(0);
  const auto [last, last_error] = mean_of(steps.size() - third);
  const double drift = last / first - 1;
  constexpr double least = 5e-4;
  if (!(std::abs(drift) > std::max(least, 5 * std::hypot(first_error, last_error) / first))) return {};
  return Notice{"clock_drifts", {{"percent", 100 * drift}}};
}

}  // namespace cromer::core
