// The study file of one fit: TOML for `cromer report` (study_file.h), written from the fit itself.
#pragma once

#include <string>
#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// A study that fits the same recording with the same options, as they were typed, and whose page has the
/// law with its numbers, the recording, and the decay rate against the amplitude. The recording is due beside
/// it. Empty if there is no fit.
std::string fit_study(const FittedRecording& fitted, const std::vector<TypedOption>& options);

}  // namespace cromer::core
