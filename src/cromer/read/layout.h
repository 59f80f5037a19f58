// Stage 4: which separator and decimal mark the rows have.
#pragma once

#include <string_view>
#include <vector>

#include "cromer/read/cells.h"
#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core::dialects {

/// The layout under which most sampled lines are rows of numbers. If none is, an Error (without the file's
/// name).
Result<Layout> find_layout(const std::vector<std::string_view>& lines, const ReadOptions& options);

/// The first line (index) that is a row of this layout, even if one of its cells is bad.
std::size_t find_data(const std::vector<std::string_view>& lines, const Layout& layout);

/// Rows such as 1,234,5,678 can be read in two ways. The header or the options decide; else an Error says
/// which options would.
Result<Layout> settle_commas(const std::vector<std::string_view>& lines, const Layout& layout,
                             const ReadOptions& options);

/// "comma", "semicolon", "tab", "blanks", "none".
std::string_view separator_name(char separator);

}  // namespace cromer::core::dialects
