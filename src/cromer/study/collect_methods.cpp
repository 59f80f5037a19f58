#include <cmath>

#include "cromer/study/collect.h"

namespace cromer {

void collect(const std::string& id, const MethodMapResult& map, Results& results) {
  results.set(id + ".natural_frequency", map.natural_frequency, "rad/s");
  results.set(id + ".decay_rate", map.decay_rate, "1/s");
  for (std::size_t i = 0; i < map.curves.size(); ++i) {
    const MethodMapCurve& curve = map.curves[i];
    const std::string name = id + "." + std::to_string(i + 1);
    results.set(name + ".label", curve.method);
    // Where w h is nearest to a tenth, the place to compare methods at.
    std::size_t tenth = 0;
    for (std::size_t j = 1; j < curve.wh.size(); ++j)
      if (std::abs(std::log(curve.wh[j] / 0.1)) < std::abs(std::log(curve.wh[tenth] / 0.1))) tenth = j;
    results.set(name + ".at_a_tenth.decay_rate", curve.decay_rate[tenth], "1/s");
    results.set(name + ".at_a_tenth.frequency_error", curve.frequency_error[tenth]);
    results.set_column(name + ".wh", curve.wh, "", "natural frequency × step *ω*_{0}*h*");
    results.set_column(name + ".decay_rate", curve.decay_rate, "1/s", "decay rate");
    results.set_column(name + ".frequency_error", curve.frequency_error, "", "frequency error");
    results.set_column(name + ".decay_error", curve.decay_error, "", "damping error");
  }
}

void collect(const std::string& id, const WorkPrecisionResult& work, Results& results) {
  for (std::size_t i = 0; i < work.curves.size(); ++i) {
    const WorkPrecisionCurve& curve = work.curves[i];
    const std::string name = id + "." + std::to_string(i + 1);
    results.set(name + ".label", curve.method);
    results.set(name + ".slope", curve.slope);
    results.set_column(name + ".evaluations", curve.evaluations, "", "evaluations");
    results.set_column(name + ".error", curve.error, "", "error");
    // The evaluations for an error of one part in a million, on the line between the runs around it.
    for (std::size_t j = 1; j < curve.error.size(); ++j)
      if (curve.error[j - 1] > 1e-6 && curve.error[j] <= 1e-6) {
        const double share =
            std::log(1e-6 / curve.error[j - 1]) / std::log(curve.error[j] / curve.error[j - 1]);
        results.set(
            name + ".evaluations_for_a_millionth",
            curve.evaluations[j - 1] * std::pow(curve.evaluations[j] / curve.evaluations[j - 1], share));
        break;
      }
  }
}

}  // namespace cromer
