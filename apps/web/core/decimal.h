// Numbers in decimal, correctly rounded.
#pragma once

#include <string>

namespace cromer::core::page {

/// digits[0].digits[1]... × 10^exponent; "0" and 0 for zero.
struct Decimal {
  std::string digits;
  int exponent = 0;
};

/// The finite `value`, which is not negative, with `count` significant digits; halves to the even digit.
Decimal significant(double value, int count);

/// The same with `count` digits behind the point.
Decimal behind_point(double value, int count);

/// The fewest digits that are read back as the same double, and of those the nearest.
Decimal fewest_digits(double value);

}  // namespace cromer::core::page
