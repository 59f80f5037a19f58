// Numbers one after the other, several in a line, without separators that could be relied on.
#pragma once

#include <string_view>
#include <vector>

#include "cromer/result.h"

namespace cromer::core::dialects {

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
