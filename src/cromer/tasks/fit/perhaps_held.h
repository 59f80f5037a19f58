// Runs that are no swings but masses at rest.
#pragma once

#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// The page knows no masses at rest.
#ifdef CROMER_PAGE
inline constexpr bool fits_held_masses = false;
#else
inline constexpr bool fits_held_masses = true;
#endif

/// Where the runs of positions lie apart, each by twenty times as far as any of them moves from its middle:
/// that a spring constant follows from where they rest. Else empty.
Notice perhaps_held(const std::vector<FittedRecording>& runs);

}  // namespace cromer::core
