// Numbers with unit and uncertainty, read from text and written for people. SI inside, units at the edges.
#pragma once

#include <string>
#include <string_view>

#include "cromer/quantity.h"
#include "cromer/result.h"

namespace cromer::core {

/// Exponents of the base units a symbol stands for. The radian counts, so that rad/s and 1/s can be told
/// apart.
struct Dimension {
  signed char kilogram = 0, metre = 0, second = 0, kelvin = 0, ampere = 0, radian = 0;

  friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// A unit: SI value = factor * number + offset (the offset only for temperatures in degrees Celsius).
struct Unit {
  double factor = 1;
  double offset = 0;
  Dimension dimension;

  friend bool operator==(const Unit&, const Unit&) = default;
};

/// Reads a unit: a product or quotient of the symbols in unit.cpp's table with SI prefixes and integer powers
/// ("N/m", "kg m/s^2", "m/s²", "1/s", "kg·m⁻¹", "%", "°C", "rpm"). Hz, kHz and rpm count cycles: they are
/// rad/s times 2 pi. "g" is the gram unless `expected` has the dimension of an acceleration.
Result<Unit> parse_unit(std::string_view text, const Dimension* expected = nullptr);

/// "0.00984(3) 1/s": the uncertainty in units of the value's last digit, for tables where it would crowd the
/// number. Where that makes no sense (no uncertainty, or one of 10 and more), as format_quantity.
std::string format_concise(Quantity quantity, std::string_view unit);

/// The shortest text that reads back as the same double; "nan" and "inf" as such.
std::string shortest(double value);

/// `digits` significant digits, without exponent from 1e-4 to 1e6, true minus sign; for people.
std::string rounded(double value, int digits);

/// " × 10⁻⁵", as it follows a number.
std::string power_of_ten(int exponent);

/// An amount of memory: "1.6 GB", "240 TB", three digits with decimal prefixes; bytes >= 0.
std::string bytes_in_words(double bytes);

}  // namespace cromer::core
