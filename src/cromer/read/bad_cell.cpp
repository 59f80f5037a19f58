#include "cromer/read/bad_cell.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "cromer/base/ascii.h"
#include "cromer/base/number.h"
#include "cromer/read/cells.h"

namespace cromer::core::dialects {
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
