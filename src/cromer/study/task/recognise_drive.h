// Whether a motion taken for a free one is driven.
#pragma once

#include <optional>

#include "cromer/study/task/fit.h"

namespace cromer {

/// The same motion fitted as a driven one, where that is what it is: a free law has left structure, and a
/// steady oscillation that makes up much of the motion accounts for it. Nothing otherwise, and where the law
/// or the drive was given.
std::optional<FittedRecording> recognise_drive(const FittedRecording& free, const Series& motion,
                                               const FitOptions& options, const Watch& watch = {});

}  // namespace cromer
