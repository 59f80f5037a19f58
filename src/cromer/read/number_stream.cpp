#include "cromer/read/number_stream.h"

#include <algorithm>
#include <cmath>

#include "cromer/base/number.h"
#include "cromer/read/bad_cell.h"
#include "cromer/read/cells.h"
#include "cromer/read/in_file.h"

namespace cromer::core::dialects {

Result<NumberStream> read_numbers(const std::vector<std::string_view>& lines, std::size_t from,
                                  std::size_t most, bool until_words, long lines_before) {
  NumberStream stream;
  stream.end = std::min(from, lines.size());
  for (std::size_t i = stream.end; i < lines.size() && stream.values.size() < most; ++i) {
    std::string_view rest = lines[i];
    const std::size_t before = stream.values.size();
    const long number_of_line = lines_before + static_cast<long>(i) + 1;
    while (stream.values.size() < most) {
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r,"), rest.size()));
      if (rest.empty()) break;
      const auto number = leading_number(rest);
      const bool good = number && std::isfinite(number->value);
      const std::string_view behind = good ? rest.substr(number->length) : rest;
      const bool ends =
          good && (behind.empty() || std::string_view(" \t\r,+-").find(behind[0]) != std::string_view::npos);
      if (!ends) {
        if (until_words && stream.values.size() == before) return stream;
        const std::string_view cell = rest.substr(0, rest.find_first_of(" \t\r,"));
        const Notice seen = bad_cell(cell, '.');
        if (seen.empty()) return in_line(number_of_line, Notice{"not_a_number", {{"text", shown(cell)}}});
        return in_line(number_of_line, Notice{"not_a_number_but", {{"text", shown(cell)}, {"what", seen}}});
      }
      stream.values.push_back(number->value);
      stream.lines.push_back(number_of_line);
      rest = behind;
    }
    stream.end = i + 1;
  }
  return stream;
}

}  // namespace cromer::core::dialects
