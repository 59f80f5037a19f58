#include "cromer/base/number.h"

#include <fast_float/fast_float.h>

#include <charconv>
#include <cmath>
#include <version>

#ifndef __cpp_lib_to_chars  // the page's standard library writes no doubles
#include <fmt/format.h>
#endif

#include "cromer/base/ascii.h"

namespace cromer::core {

std::optional<LeadingNumber> leading_number(std::string_view text, char decimal) {
  constexpr std::string_view true_minus = "\u2212";
  std::size_t sign = 0;
  bool negative = false;
  const char first = text.empty() ? '\0' : text.front();
  if (first == '-' || first == '+') {
    sign = 1;
    negative = first == '-';
  } else if (first == true_minus.front() && text.starts_with(true_minus)) {  // rare, and slow to compare
    sign = true_minus.size();
    negative = true;
  }
  const std::string_view rest = text.substr(sign);
  const bool digit = !rest.empty() && is_digit(rest[0]);
  const bool fraction = rest.size() > 1 && rest[0] == decimal && is_digit(rest[1]);
  if (!digit && !fraction) return std::nullopt;
  double value = 0;
  const fast_float::parse_options options(fast_float::chars_format::general, decimal);
  const auto end = fast_float::from_chars_advanced(rest.data(), rest.data() + rest.size(), value, options);
  if (end.ptr == rest.data()) return std::nullopt;
  return LeadingNumber{negative ? -value : value, sign + static_cast<std::size_t>(end.ptr - rest.data())};
}

#ifdef __cpp_lib_to_chars

char* write_shortest(char* to, double value) { return std::to_chars(to, to + 32, value).ptr; }

namespace {
char* write_15_digits(char* to, double value) {
  return std::to_chars(to, to + 32, value, std::chars_format::general, 15).ptr;
}
}  // namespace

#else

char* write_shortest(char* to, double value) { return fmt::format_to(to, "{}", value); }

namespace {
char* write_15_digits(char* to, double value) { return fmt::format_to(to, "{:.15g}", value); }
}  // namespace

#endif

double to_15_digits(double value) {
  if (!std::isfinite(value)) return value;
  char digits[32];
  double clean = value;
  fast_float::from_chars(digits, write_15_digits(digits, value), clean);
  return clean;
}

}  // namespace cromer::core
