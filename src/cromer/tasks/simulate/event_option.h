// What `--event` says, read.
#pragma once

#include <string_view>

#include "cromer/result.h"
#include "cromer/run/event.h"

namespace cromer::core {

/// Reads `position=VALUE`, `velocity=VALUE` or `turning-point` (velocity = 0), then any of `:rising`,
/// `:falling` (which way the quantity goes) and `:stop` (the run ends there): "position=1 cm:falling:stop".
/// An Error names what was expected.
Result<Event> parse_event(std::string_view text);

}  // namespace cromer::core
