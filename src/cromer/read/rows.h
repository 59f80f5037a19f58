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
  std::size_t bad_rows = 0;                  ///< dropped because the caller wanted that
  long first_bad_line = 0;
  Notice first_complaint;  ///< what is wrong in that line
  Notice last_line;        ///< what is to be said of it, where the text ends within it
};

/// Which lines of the file hold rows, and what to make of those that are none.
struct RowRules {
  std::size_t from = 0, to = 0;  ///< indices of the first line and of the one behind the last
  bool skip_bad_rows = false;
  bool ignore_beyond = false;    ///< cells behind the last column are remarks, not values
  std::size_t lines_before = 0;  ///< lines of the file above the first of those given
};

/// Reads rows of numbers. `names` are the columns' for notices. A word, more values than columns, or commas
/// that cannot be told apart, are an Error of in_line, unless `skip_bad_rows`. Where the text ends within a
/// line (a logger that lost power) its last number may be cut: with fewer decimals than all before have, who
/// have equally many, the row is left out.
Result<Rows> read_rows(const std::vector<std::string_view>& lines, const Layout& layout,
                       const std::vector<std::string>& names, const RowRules& rules);

/// Where no line is a row: an Error of in_line with the first cell that begins as a number does and is none
/// (a clock time, thousands separators, ...), else the reason.
Error no_rows(const std::vector<std::string_view>& lines, const Error& reason, std::size_t lines_before);

struct NumberStream {
  std::vector<double> values;
  std::vector<long> lines;  ///< line number of each
  std::size_t end = 0;      ///< index of the line behind the last that was read
};

/// At most `most` numbers from the lines with indices from `from` on, between blanks or commas or stuck
/// together by a sign (1.234-5.678); stops before a line that begins with none where `until_words`, else that
/// is an Error of in_line. `lines_before` lines of the file stand above the first of those given.
Result<NumberStream> read_numbers(const std::vector<std::string_view>& lines, std::size_t from,
                                  std::size_t most, bool until_words, long lines_before = 0);

}  // namespace cromer::core::dialects
