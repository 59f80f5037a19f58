// Runs that are no swings but masses at rest.
#pragma once

#include <vector>

#include "cromer/base/for_page.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// The page knows no masses at rest.
inline constexpr bool fits_held_masses = !for_page;

/// Where the runs of positions lie apart, each by twenty times as far as any of them moves from its middle,
/// or one without a law rests at several levels (levels_at_rest()): that a spring constant follows from where
/// they rest. Else empty.
Notice perhaps_held(const std::vector<FittedRecording>& runs);

}  // namespace cromer::core
