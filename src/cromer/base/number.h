// One number read from text, the same on every platform and in every locale.
#pragma once

#include <optional>
#include <string_view>

namespace cromer::core {

/// The number that begins `text` and, in `length`, how many bytes it takes: "-3.75e-5 m" gives -3.75e-5
/// and 8. A leading + and the true minus sign (U+2212) are understood, words (nan, inf) and hexadecimal are
/// not. Correctly rounded; beyond the doubles it is infinite.
struct LeadingNumber {
  double value = 0;
  std::size_t length = 0;
};
std::optional<LeadingNumber> leading_number(std::string_view text, char decimal = '.');

/// Writes the fewest digits that read back as the same double; the end of what was written. At most 32
/// characters; finite numbers only.
char* write_shortest(char* to, double value);

/// The double nearest to `value` written with 15 significant digits: 23.61 steps of 0.01 read 0.2361, not
/// 0.23610000000000003.
double to_15_digits(double value);

}  // namespace cromer::core
