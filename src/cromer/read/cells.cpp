#include "cromer/read/cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "cromer/base/ascii.h"
#include "cromer/base/number.h"

namespace cromer::core::dialects {

std::vector<std::string_view> split_lines(std::string_view text) {
  const char end = text.find('\n') == std::string_view::npos ? '\r' : '\n';
  std::vector<std::string_view> lines;
  lines.reserve(text.size() / 24 + 1);
  while (!text.empty()) {
    const std::size_t length = text.find(end);
    std::string_view line = text.substr(0, length);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    lines.push_back(line);
    if (length == std::string_view::npos) return lines;
    text.remove_prefix(length + 1);
  }
  lines.emplace_back();
  return lines;
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

bool is_comment(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && (line[first] == '#' || line[first] == '%');
}

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

namespace {

/// Digits become 0, runs of them one: "12:00:00.50" is "0:0:0.0".
std::string shape_of(std::string_view cell) {
  std::string shape;
  for (const char c : cell)
    if (!is_digit(c))
      shape += c;
    else if (shape.empty() || shape.back() != '0')
      shape += '0';
  return shape;
}

bool is_clock(std::string_view shape) { return shape.starts_with("0:0"); }

bool is_date(std::string_view shape) {
  return shape.starts_with("0-0-0") || shape.starts_with("0/0/0") || shape.starts_with("0.0.0 ") ||
         shape == "0.0.0";
}

/// 1,234,567.5 or 1.234,5: the number without its separators, "" if it has none. A single separator and
/// nothing behind its three digits may be a decimal mark: that is left open.
std::string without_thousands(std::string_view cell) {
  for (const char mark : {',', '.'}) {
    const char decimal = mark == ',' ? '.' : ',';
    std::string plain;
    std::size_t i = 0, marks = 0;
    if (i < cell.size() && (cell[i] == '-' || cell[i] == '+')) plain += cell[i++];
    const std::size_t first = i;
    while (i < cell.size() && is_digit(cell[i])) plain += cell[i++];
    if (i == first || i - first > 3) continue;
    while (i + 3 < cell.size() && cell[i] == mark && is_digit(cell[i + 1]) && is_digit(cell[i + 2]) &&
           is_digit(cell[i + 3]) && (i + 4 == cell.size() || !is_digit(cell[i + 4]))) {
      plain.append(cell.substr(i + 1, 3));
      i += 4;
      ++marks;
    }
    if (marks == 0) continue;
    if (i == cell.size()) return marks > 1 ? plain : std::string{};
    if (cell[i] != decimal) continue;
    plain += '.';
    for (++i; i < cell.size() && is_digit(cell[i]); ++i) plain += cell[i];
    if (i == cell.size()) return plain;
  }
  return {};
}

/// 1.5D-03 as 1.5E-03; "" if it is none.
std::string without_fortran(std::string_view cell, char decimal) {
  std::string plain(cell);
  const std::size_t at = plain.find_first_of("dD");
  if (at == std::string::npos || at == 0 || at + 1 == plain.size()) return {};
  plain[at] = 'E';
  return read_cell(plain, decimal).kind == CellKind::number ? plain : std::string{};
}

}  // namespace

Notice bad_cell(std::string_view cell, char decimal) {
  if (std::string plain = without_thousands(cell); !plain.empty()) {
    std::replace(plain.begin(), plain.end(), '.', decimal);
    return Notice{"has_thousands_separators", {{"cure", plain}}};
  }
  const std::string shape = shape_of(cell);
  if (is_date(shape)) return Notice{"is_date"};
  if (is_clock(shape)) return Notice{"is_clock_time"};
  if (const std::string plain = without_fortran(cell, decimal); !plain.empty())
    return Notice{"has_fortran_exponent", {{"cure", plain}}};
  if (const auto number = leading_number(cell, decimal);
      number && number->length == cell.size() && !std::isfinite(number->value))
    return Notice{"is_too_large"};
  const char other = decimal == '.' ? ',' : '.';
  if (read_cell(cell, other).kind == CellKind::number)
    return Notice{decimal == '.' ? "decimal_mark_is_point" : "decimal_mark_is_comma"};
  return {};
}

}  // namespace cromer::core::dialects
