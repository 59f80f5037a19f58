// Checks that both kinds of modes share.
#pragma once

#include "cromer/methods/method_settings.h"
#include "cromer/tasks/modes/modes.h"

namespace cromer::core {

/// Each option's own range, and names of methods that take steps.
Result<void> check_modes_options(ModesOptions options);

/// An option that only recordings take, if one is given; else "".
std::string_view option_of_recordings(const ModesOptions& options);

/// Whether no mode is left out for what the options say.
bool seeks_all(const ModesOptions& options);

MethodSettings method_settings_of(const ModesOptions& options);

}  // namespace cromer::core
