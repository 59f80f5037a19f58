#include <cmath>
#include <limits>

#include "cromer/study/collect.h"

namespace cromer::core {

void collect(const std::string& id, const MethodMapResult& map, Results& results) {
  results.set(id + ".natural_frequency", map.natural_frequency, "rad/s");
  results.set(id + ".decay_rate", map.decay_rate, "1/s");
  for (std::size_t i = 0; i < map.curves.size(); ++i) {
    const MethodMapCurve& curve = map.curves[i];
    const std::string name = id + "." + std::to_string(i + 1);
    results.set(name + ".label", curve.method);
    if (curve.order > 0)
      results.set(name + ".order", static_cast<double>(curve.order));
    else
      results.set(name + ".order", std::string("–"));
    results.set(name + ".at_a_tenth.decay_rate", curve.at_a_tenth.decay_rate, "1/s");
    results.set(name + ".at_a_tenth.frequency_error", curve.at_a_tenth.frequency_error);
    results.set(name + ".at_a_tenth.energy_factor", curve.at_a_tenth.energy_factor);
    if (curve.stable_up_to)
      results.set(name + ".stable_up_to", *curve.stable_up_to);
    else
      results.set(name + ".stable_up_to", std::string("any"));
    const auto column = [&](double MethodMapPoint::*which) {
      std::vector<double> values;
      for (const MethodMapPoint& point : curve.at) values.push_back(point.*which);
      return values;
    };
    results.set_column(name + ".wh", curve.wh, "", "natural frequency × step *ω*_{0}*h*");
    results.set_column(name + ".decay_rate", column(&MethodMapPoint::decay_rate), "1/s", "decay rate");
    results.set_column(name + ".frequency_error", column(&MethodMapPoint::frequency_error), "",
                       "frequency error");
    results.set_column(name + ".decay_error", column(&MethodMapPoint::decay_error), "", "damping error");
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
    constexpr double not_reached = std::numeric_limits<double>::quiet_NaN();
    results.set(name + ".evaluations_for_a_millionth", not_reached);
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

}  // namespace cromer::core
