#include "cromer/identify/modal/modal_record.h"

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

}  // namespace cromer::core
