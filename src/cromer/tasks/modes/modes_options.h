// What the modes of networks and of recordings ask of their options.
#pragma once

#include <string>
#include <string_view>

#include "cromer/methods/method_settings.h"
#include "cromer/read/channels.h"
#include "cromer/tasks/modes/modes.h"

namespace cromer::core {

/// Each option's own range, and names of methods that take steps, which `method_option` gives.
Result<void> check_modes_options(ModesOptions options, std::string_view method_option = "method");

/// An option that only recordings take, if one is given; else "".
std::string_view option_of_recordings(const ModesOptions& options);

/// Whether the options leave out no mode: neither by frequency nor by number.
bool seeks_all(const ModesOptions& options);

/// An Error where one of several channels stops in full swing and keeps one value from there on, as where its
/// sensor or its cable fails. `file`: as messages name it.
Result<void> check_no_channel_dies(const Channels& channels, const std::string& file);

MethodSettings method_settings_of(const ModesOptions& options);

}  // namespace cromer::core
