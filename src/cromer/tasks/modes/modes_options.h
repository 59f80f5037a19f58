// What the modes of networks and of recordings ask of their options.
#pragma once

#include "cromer/methods/method_settings.h"
#include "cromer/tasks/modes/modes.h"

namespace cromer::core {

/// Each option's own range, and names of methods that take steps.
Result<void> check_modes_options(ModesOptions options);

/// An option that only recordings take, if one is given; else "".
std::string_view option_of_recordings(const ModesOptions& options);

/// Whether the options leave out no mode: neither by frequency nor by number.
bool seeks_all(const ModesOptions& options);

MethodSettings method_settings_of(const ModesOptions& options);

}  // namespace cromer::core
