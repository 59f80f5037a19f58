// Why a run ended before its end.
#pragma once

#include "cromer/notice.h"
#include "cromer/run/course.h"

namespace cromer::core {

/// With the last good time and step; empty if it reached its end, or an event that was to stop it.
Notice early_end(const Outcome& outcome);

}  // namespace cromer::core
