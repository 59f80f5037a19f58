#include "cromer/report/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "cromer/base/utf8.h"

namespace cromer::core {
namespace {

constexpr std::size_t longest_number = 32;
constexpr std::size_t block = 4096;  // rows that memory is taken for at their longest

// Text as a cell, quoted if it holds a character that would end the cell.
std::string cell_text(const std::string& name) {
  const std::string text = printable(name);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::size_t rows_of(std::span<const CsvColumn> columns) {
  std::size_t rows = 0;
  for (const CsvColumn& column : columns) {
    if (const auto* numbers = std::get_if<std::span<const double>>(&column.cells))
      rows = std::max(rows, numbers->size());
  }
  return rows;
}

}  // namespace

void append_csv(std::string& out, std::span<const CsvColumn> columns, std::span<const std::string> comments,
                bool with_header) {
  for (std::string comment : comments) {
    if (comment.empty()) continue;
    for (std::size_t i = 0; (i = comment.find('\n', i)) != std::string::npos; i += 3)
      comment.insert(i + 1, "# ");
    out.append("# ").append(printable(comment)).append("\n");
  }
  if (with_header) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c > 0) out += ',';
      out += cell_text(columns[c].header);
    }
    out += '\n';
  }

  std::vector<std::string> texts(columns.size());
  std::size_t longest_row = 1;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (const auto* text = std::get_if<std::string>(&columns[c].cells)) texts[c] = cell_text(*text);
    longest_row += std::max(texts[c].size(), longest_number) + 1;
  }
  const std::size_t rows = rows_of(columns);
  for (std::size_t first = 0; first < rows; first += block) {
    const std::size_t last = std::min(rows, first + block), start = out.size();
    out.resize(start + (last - first) * longest_row);  // the longest it can be; cut to size below
    char* p = out.data() + start;
    for (std::size_t r = first; r < last; ++r) {
      for (std::size_t c = 0; c < columns.size(); ++c) {
        if (c > 0) *p++ = ',';
        if (const auto* numbers = std::get_if<std::span<const double>>(&columns[c].cells)) {
          if (r < numbers->size() && !std::isnan((*numbers)[r]))
            p = std::to_chars(p, p + longest_number, (*numbers)[r]).ptr;
        } else {
          std::memcpy(p, texts[c].data(), texts[c].size());
          p += texts[c].size();
        }
      }
      *p++ = '\n';
    }
    out.resize(static_cast<std::size_t>(p - out.data()));
    // Rows have similar lengths: reserves room for all of them, and an eighth more.
    if (first == 0 && last < rows)
      out.reserve(start + (out.size() - start) / (last - first) * rows / 8 * 9 + longest_row * block);
  }
}

}  // namespace cromer::core
