// Numbers in text, the same on every platform and in every locale.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace cromer::core {

/// Blanks that may stand beside a number: no-break and thin ones too.
inline constexpr std::array<std::string_view, 6> quantity_blanks{" ",      "\t",     "\r",
                                                                 "\u00a0", "\u202f", "\u2009"};

/// The digits 0 to 9 as powers are written: ⁰ to ⁹.
inline constexpr std::array<std::string_view, 10> superscript_digits{
    "\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074", "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};

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
