#include <algorithm>
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
  const double s = slow.value, f = fast.value, sum = f * f + s * s;
  const Estimate beat = of_both(slow, fast, f - s, -1, 1);
  const auto swings = [](const NaturalMode& mode) {
    return mode.frequency.value > 0 && !(std::abs(mode.damping_ratio.value) >= 1);
  };
  if (!(beat.low > 0 && swings(result.modes[0]) && swings(result.modes[1]))) return std::nullopt;
  return Beat{beat,
              {1 / beat.value, beat.standard_error / (beat.value * beat.value), 1 / beat.high, 1 / beat.low},
              of_both(slow, fast, beat.value * (f + s) / sum, -4 * s * f * f / (sum * sum),
                      4 * f * s * s / (sum * sum))};
}

}  // namespace cromer::core
