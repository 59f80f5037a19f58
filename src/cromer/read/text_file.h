// A file that is text: its dialect is found and its table read.
#pragma once

#include <string_view>

#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core::dialects {

/// All stages but those of time, which see the whole recording.
Result<Recording> read_text_file(std::string_view bytes, std::string_view file, const ReadOptions& options);

}  // namespace cromer::core::dialects
