// Stage 2: text to lines.
#pragma once

#include <string_view>
#include <vector>

namespace cromer::core::dialects {

/// The lines of a text ended by LF, CR LF or (where there is no LF) CR, without their ends. Line i of the
/// file is lines[i - 1]. The last one is empty, but for a text that ends within a line.
std::vector<std::string_view> split_lines(std::string_view text);

/// Without blanks, tabs and no-break spaces at both ends.
std::string_view trimmed(std::string_view text);

/// A line to skip among data: nothing but blanks, or a comment (# or %).
bool is_blank(std::string_view line);
bool is_comment(std::string_view line);

}  // namespace cromer::core::dialects
