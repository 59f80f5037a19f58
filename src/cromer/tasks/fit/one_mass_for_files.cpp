#include "cromer/tasks/fit/one_mass.h"

namespace cromer::core {

void doubt_one_mass_for_files(std::vector<FittedRecording>& fits) {
  const auto spread = unlike_frequencies(fits);
  if (!spread || fits[spread->lowest].file == fits[spread->highest].file) return;
  FittedRecording& high = fits[spread->highest];
  high.notices.insert(high.notices.begin() + static_cast<std::ptrdiff_t>(high.of_file),
                      Notice{"one_mass_for_unlike_files",
                             {{"percent", spread->percent}, {"low", fits[spread->lowest].file}}});
  ++high.of_record;
}

}  // namespace cromer::core
