#include <cmath>

#include "cromer/tasks/modes/modes.h"

namespace cromer::core {
namespace {

/// f(slow, fast) with the derivatives by both.
Estimate of_both(const Estimate& slow, const Estimate& fast, double value, double by_slow, double by_fast) {
  const double error = std::hypot(by_slow * slow.standard_error, by_fast * fast.standard_error);
  const auto times = [](const Estimate& e) {
    return e.standard_error > 0 ? (e.high - e.low) / (2 * e.standard_error) : 0;
  };
  const double reach = std::max(times(slow), times(fast)) * error;
  return {value, error, value - reach, value + reach};
}

}  // namespace

std::optional<Beat> beat_of(const ModesResult& result) {
  if (result.modes.size() != 2) return std::nullopt;
  const Estimate &slow = result.modes[0].frequency, &fast = result.modes[1].frequency;
  const double s = slow.value, f = fast.value, beat = f - s, sum = f * f + s * s;
  if (!(beat > 0)) return std::nullopt;
  return Beat{
      of_both(slow, fast, beat, -1, 1), of_both(slow, fast, 1 / beat, 1 / (beat * beat), -1 / (beat * beat)),
      of_both(slow, fast, beat * (f + s) / sum, -4 * s * f * f / (sum * sum), 4 * f * s * s / (sum * sum))};
}

}  // namespace cromer::core
