// A small table of words for a terminal.
#pragma once

#include <string>
#include <vector>

namespace cromer::core {

/// Rows of cells under a header, columns as wide as their widest cell (in characters, not bytes); the columns
/// from `numbers_from` to `numbers_to` (exclusive) are flushed right.
std::string text_table(const std::vector<std::vector<std::string>>& rows, std::size_t numbers_from,
                       std::size_t numbers_to);

}  // namespace cromer::core
