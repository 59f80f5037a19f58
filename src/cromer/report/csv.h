// Tables as CSV text; each number reads back as the same double.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cromer::core {

/// A column to write: its header and its numbers. A text column (a run's label) repeats one text in all rows
/// of a block.
struct CsvColumn {
  std::string header;
  std::variant<std::span<const double>, std::string> cells;
};

/// `comments`, but for empty ones, become lines beginning with "# ". Appends one block of rows to `out`; the
/// header line only if `with_header`. NaN is an empty cell. Cost: about 1.9 ms for 8000 rows of three
/// (std::to_chars, no formatting library).
void append_csv(std::string& out, std::span<const CsvColumn> columns, std::span<const std::string> comments,
                bool with_header);

}  // namespace cromer::core
