#include "cromer/tasks/fit/one_mass.h"

#include <algorithm>

namespace cromer::core {

std::optional<UnlikeFrequencies> unlike_frequencies(const std::vector<FittedRecording>& fits) {
  constexpr double alike = 1.03;  // of one oscillator, started in different ways
  std::optional<std::size_t> lowest, highest;
  const auto w = [&](std::size_t i) { return fits[i].fit.angular_frequency(); };
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (!fits[i].succeeded() || !fits[i].find("stiffness")) continue;
    if (!lowest || w(i).high < w(*lowest).high) lowest = i;
    if (!highest || w(i).low > w(*highest).low) highest = i;
  }
  if (!lowest || !(w(*highest).low > alike * w(*lowest).high)) return std::nullopt;
  return UnlikeFrequencies{*lowest, *highest, 100 * (w(*highest).low / w(*lowest).high - 1)};
}

void doubt_one_mass_for_files(std::vector<FittedRecording>& fits) {
  const auto spread = unlike_frequencies(fits);
  if (!spread || fits[spread->lowest].file == fits[spread->highest].file) return;
  FittedRecording& high = fits[spread->highest];
  high.notices.insert(high.notices.begin() + static_cast<std::ptrdiff_t>(high.of_file),
                      Notice{"one_mass_for_unlike_files",
                             {{"percent", spread->percent}, {"low", fits[spread->lowest].file}}});
}

}  // namespace cromer::core
