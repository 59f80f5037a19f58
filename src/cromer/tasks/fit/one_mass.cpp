#include "cromer/tasks/fit/one_mass.h"

#include <algorithm>

#include "cromer/tasks/fit/lab_quantities.h"

namespace cromer::core {

std::optional<UnlikeFrequencies> unlike_frequencies(const std::vector<FittedRecording>& fits) {
  constexpr double alike = 1.03;  // of one oscillator, started in different ways
  std::optional<std::size_t> lowest, highest;
  const auto w = [&](std::size_t i) { return angular_frequency_of(fits[i]); };
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (!fits[i].succeeded() || !fits[i].find("stiffness")) continue;
    if (!lowest || w(i).high < w(*lowest).high) lowest = i;
    if (!highest || w(i).low > w(*highest).low) highest = i;
  }
  if (!lowest || !(w(*highest).low > alike * w(*lowest).high)) return std::nullopt;
  return UnlikeFrequencies{*lowest, *highest, 100 * (w(*highest).low / w(*lowest).high - 1)};
}

}  // namespace cromer::core
