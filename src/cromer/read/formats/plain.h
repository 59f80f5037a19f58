// The common table: one header, rows under it, whatever program wrote it.
#pragma once

#include <string_view>
#include <vector>

#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core::dialects {

/// Stages 4 to 7 on the lines of a file: layout, header, rows, runs. `lines_before` lines of the file stand
/// above those given.
Result<Recording> read_plain(const std::vector<std::string_view>& lines, const ReadOptions& options,
                             std::size_t lines_before = 0);

}  // namespace cromer::core::dialects
