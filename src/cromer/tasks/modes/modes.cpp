#include "cromer/tasks/modes/modes.h"

#include <cmath>

#include "cromer/base/pi.h"

namespace cromer::core {

std::optional<double> ModeByMethod::frequency() const {
  const auto &b = effect.effective.decay_rate, &w = effect.effective.angular_frequency;
  return b && w ? std::optional(std::hypot(*b, *w) / two_pi) : std::nullopt;
}

std::optional<double> ModeByMethod::damping_ratio() const {
  const auto &b = effect.effective.decay_rate, &w = effect.effective.angular_frequency;
  return b && w ? std::optional(*b / std::hypot(*b, *w)) : std::nullopt;
}

}  // namespace cromer::core
