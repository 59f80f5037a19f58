// The tasks' messages for callers of the library: they speak of arguments instead of options, and of samples
// instead of lines.
#pragma once

#include <string>
#include <vector>

#include "cromer/documents/words/words.h"
#include "cromer/result.h"

namespace cromer::core {

/// The message as callers get it; `of_arrays` where they passed arrays. The Error's argument is the one that
/// its sentence begins with or, where arrays were passed, the one that it is about.
Notice in_arguments(Notice notice, bool of_arrays = false);
std::vector<Notice> in_arguments(std::vector<Notice> notices, bool of_arrays = false);
Error in_arguments(Error error, bool of_arrays = false);

/// The sentence in English, as fields hold it; "" where there is nothing to say.
std::string message_of(const Notice& notice);

}  // namespace cromer::core
