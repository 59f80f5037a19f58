// Stage 4: which separator and decimal mark the rows have.
#pragma once

#include <string_view>
#include <vector>

#include "cromer/read/cells.h"
#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core::dialects {

/// The layout under which most sampled lines are rows of numbers. If none is, that under which they are with
/// columns of text among them; else an Error (without the file's name).
Result<Layout> find_layout(const std::vector<std::string_view>& lines, const ReadOptions& options);

/// The first line (index) that is a row of this layout, even if one of its cells is bad.
std::size_t find_data(const std::vector<std::string_view>& lines, const Layout& layout);

/// Rows such as 1,234,5,678 can be read in two ways. The header or the options decide; else an Error says
/// which options would.
Result<Layout> settle_commas(const std::vector<std::string_view>& lines, const Layout& layout,
                             const ReadOptions& options);

/// The columns without a number in any line from `data` on, but with words: labels, which are no numbers
/// badly written. Dates and clock times count as such if another column, by its name, is a time. Empty where
/// there is none, or where too few columns would be left.
std::vector<bool> text_columns(const std::vector<std::string_view>& lines, std::size_t data,
                               const Layout& layout, const ReadOptions& options,
                               const std::vector<bool>& named_time);

/// "comma", "semicolon", "tab", "blanks", "none".
std::string_view separator_name(char separator);

}  // namespace cromer::core::dialects
