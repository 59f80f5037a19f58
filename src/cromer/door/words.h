// What the tasks say, in the words of a call: arguments for options, samples for lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/result.h"

namespace cromer::core {

/// "drive-frequency" becomes "drive_frequency", and back.
std::string argument_of(std::string_view option);
std::string option_of(std::string_view argument);

/// "--drive-frequency" becomes "drive_frequency"; of arrays "line 7" becomes "sample 7".
std::string in_arguments(std::string_view text, bool of_arrays = false);

std::vector<std::string> in_arguments(const std::vector<std::string>& texts, bool of_arrays = false);

/// The same of an Error; its argument is the one that the message begins with.
Error in_arguments(const Error& error, bool of_arrays = false);

}  // namespace cromer::core
