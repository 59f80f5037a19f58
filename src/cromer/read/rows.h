// Stage 6: lines to columns of numbers, or to numbers one after the other.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/read/cells.h"
#include "cromer/result.h"

namespace cromer::core::dialects {

struct Rows {
  std::vector<std::vector<double>> columns;  ///< of equal length; NaN where a value is missing
  std::vector<long> lines;                   ///< line number of each row, from 1
  std::size_t bad_rows = 0;                  ///< dropped, by skip_bad_rows
  long first_bad_line = 0;
  Notice first_complaint;  ///< what is wrong in that line
  Notice last_line;        ///< about the last line, if it has no line end
};

/// Which lines of the file hold rows, and what becomes of lines that are no rows.
struct RowRules {
  std::size_t from = 0, to = 0;  ///< indices of the first line and of the one after the last
  bool skip_bad_rows = false;
  bool ignore_beyond = false;    ///< cells after the last column are remarks, not values
  std::size_t lines_before = 0;  ///< lines of the file above the first of those given
};

/// Reads rows of numbers. `names` are the columns' names for notices. A word, more values than columns, or
/// ambiguous commas are an Error of in_line, unless `skip_bad_rows`. If the text ends without a line end (a
/// logger that lost power), its last number may be cut: the row is left out if that number has fewer decimals
/// than all above it, which have the same number of them.
Result<Rows> read_rows(const std::vector<std::string_view>& lines, const Layout& layout,
                       const std::vector<std::string>& names, const RowRules& rules);

/// The Error of a file without rows: in_line with the first cell that begins like a number but is none (a
/// clock time, thousands separators, ...), else `reason`.
Error no_rows(const std::vector<std::string_view>& lines, const Error& reason, std::size_t lines_before);

struct NumberStream {
  std::vector<double> values;
  std::vector<long> lines;  ///< line number of each
  std::size_t end = 0;      ///< index of the line after the last that was read
};

/// Reads at most `most` numbers from line index `from` on, separated by blanks, by commas or by a sign alone
/// (1.234-5.678). A line that does not begin with a number ends the stream if `until_words`; else it is an
/// Error of in_line. `lines_before` lines of the file stand above the first of those given.
Result<NumberStream> read_numbers(const std::vector<std::string_view>& lines, std::size_t from,
                                  std::size_t most, bool until_words, long lines_before = 0);

}  // namespace cromer::core::dialects
