// Stage 6: rows to columns of numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/result.h"
#include "cromer/record/dialects/cells.h"

namespace cromer::dialects {

struct Rows {
  std::vector<std::vector<double>> columns;  ///< of equal length; NaN where a value is missing
  std::vector<long> lines;                   ///< line number of each row, from 1
  std::size_t bad_rows = 0;                  ///< dropped because the caller wanted that
  long first_bad_line = 0;
  std::string first_complaint;  ///< what is wrong in that line
};

/// Reads the lines from index `data` on. `names` are the columns' for messages. A word, or more values than
/// columns, is an Error that begins with
/// ":LINE: " (the caller puts the file's name in front), unless `skip_bad_rows`.
Result<Rows> read_rows(const std::vector<std::string_view>& lines, std::size_t data, const Layout& layout,
                       const std::vector<std::string>& names, bool skip_bad_rows);

/// The message where no line is a row: ":LINE: ..." with the first cell that begins as a number does and is
/// none (a clock time, thousands separators, ...), else ": REASON".
std::string no_rows(const std::vector<std::string_view>& lines, std::string_view reason);

}  // namespace cromer::dialects
