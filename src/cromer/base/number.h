// One number read from text, the same on every platform and in every locale.
#pragma once

#include <optional>
#include <string_view>

namespace cromer {

/// The number that begins `text` and, in `length`, how many bytes it takes: "-3.75e-5 m" gives -3.75e-5 and 8. A leading + and the true minus sign
/// (U+2212) are understood, words (nan, inf) and hexadecimal are not. Correctly rounded; beyond the doubles it is infinite.
struct LeadingNumber {
  double value = 0;
  std::size_t length = 0;
};
std::optional<LeadingNumber> leading_number(std::string_view text, char decimal = '.');

}  // namespace cromer
