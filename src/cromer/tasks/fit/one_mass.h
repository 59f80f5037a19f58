// Whether fits for which one mass is used swing alike.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// Two of the fits, and by how much their frequencies surely differ.
struct UnlikeFrequencies {
  std::size_t lowest, highest;
  double percent;
};

/// The two whose frequencies differ most, if one mass on one spring does not explain it. Only fits with a
/// spring constant count.
std::optional<UnlikeFrequencies> unlike_frequencies(const std::vector<FittedRecording>& fits);

/// Says so at the fit with the highest frequency, of several files for all of which one mass is used.
void doubt_one_mass_for_files(std::vector<FittedRecording>& fits);

}  // namespace cromer::core
