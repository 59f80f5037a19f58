#include "cromer/read/cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cromer/base/ascii.h"
#include "cromer/base/number.h"
#include "cromer/read/lines.h"

namespace cromer::core::dialects {
namespace {

bool equal_without_case(std::string_view a, std::string_view small) {
  return std::equal(a.begin(), a.end(), small.begin(), small.end(),
                    [](char one, char other) { return lower(one) == other; });
}

bool is_missing_mark(std::string_view cell) {
  constexpr std::array<std::string_view, 16> marks{"",      "nan",  "null", "na",      "n/a",  "#n/a",
                                                   "-",     "--",   "---",  "inf",     "-inf", "undefined",
                                                   "undef", "-nan", "none", "infinity"};
  return std::any_of(marks.begin(), marks.end(), [&](auto mark) { return equal_without_case(cell, mark); });
}

}  // namespace

Error too_many_columns() { return Error{"too_many_columns", {{"most", most_columns}}}; }

bool commas_pair_up(std::string_view line, const Layout& layout) {
  if (!layout.paired) return true;
  const auto commas = static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
  return commas % 2 == 1 && (layout.columns <= 1 || commas + 1 == 2 * layout.columns);
}

CellReader::CellReader(std::string_view line, const Layout& layout)
    : rest_(line), separator_(layout.separator), decimal_(layout.decimal), paired_(layout.paired) {
  if (separator_ == ' ') rest_ = trimmed(rest_);
}

std::size_t CellReader::cell_end() const {
  if (separator_ == 0) return rest_.size();
  const std::size_t first = rest_.find_first_not_of(separator_ == '\t' ? " " : " \t");
  const bool quotes = first != std::string_view::npos && rest_[first] == '"';
  std::size_t from = 0;
  if (quotes) {  // the closing quote is one that is not doubled
    from = first + 1;
    for (;;) {
      from = rest_.find('"', from);
      if (from == std::string_view::npos) return rest_.size();
      ++from;
      if (from >= rest_.size() || rest_[from] != '"') break;
      ++from;
    }
  }
  std::size_t end = separator_ == ' ' ? rest_.find_first_of(" \t", from) : rest_.find(separator_, from);
  if (paired_ && !quotes && end != std::string_view::npos) end = rest_.find(separator_, end + 1);
  return std::min(end, rest_.size());
}

bool CellReader::next(std::string_view& cell) {
  if (!more_) return false;
  const std::size_t end = cell_end();
  cell = trimmed(rest_.substr(0, end));
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
    cell = trimmed(cell.substr(1, cell.size() - 2));
  more_ = end < rest_.size();
  if (more_) rest_.remove_prefix(end + 1);
  if (separator_ == ' ') rest_ = rest_.substr(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
  return true;
}

bool CellReader::next_number(double& value) {
  if (!more_ || paired_ || separator_ == ' ') return false;
  const auto number = leading_number(rest_, decimal_);
  if (!number || !std::isfinite(number->value)) return false;
  const bool last = number->length == rest_.size();
  const bool open = decimal_ == ',' && rest_[number->length - 1] == ',';
  if (open || (!last && rest_[number->length] != separator_)) return false;
  value = number->value;
  more_ = !last;
  if (more_) rest_.remove_prefix(number->length + 1);
  return true;
}

void split_cells(std::string_view line, const Layout& layout, std::vector<std::string_view>& cells) {
  cells.clear();
  CellReader reader(line, layout);
  for (std::string_view cell; cells.size() <= most_columns && reader.next(cell);) cells.push_back(cell);
}

Cell read_cell(std::string_view cell, char decimal) {
  const auto number = leading_number(cell, decimal);
  const bool whole = number && number->length == cell.size();
  // "1." is a number, "1," is a list that goes on.
  const bool open = decimal == ',' && cell.ends_with(',');
  if (whole && !open && std::isfinite(number->value)) return {CellKind::number, number->value};
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {is_missing_mark(cell) ? CellKind::missing : CellKind::word, nan};
}

std::string shown(std::string_view cell) {
  constexpr std::size_t longest = 40;
  std::size_t length = std::min(cell.size(), longest);
  while (length > 0 && length < cell.size() && (static_cast<unsigned char>(cell[length]) & 0xC0u) == 0x80u)
    --length;
  std::string text;
  for (const char c : cell.substr(0, length))
    text += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  if (length < cell.size()) text += "…";
  return text;
}

}  // namespace cromer::core::dialects
