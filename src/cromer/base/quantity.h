// Numbers with unit and uncertainty, read from text and written for people. SI inside, units at the edges.
#pragma once

#include <string>
#include <string_view>

#include "cromer/base/result.h"

namespace cromer {

/// A value and its standard uncertainty (k = 1), both in the coherent SI unit of whatever it measures; angles
/// in rad.
struct Quantity {
  double value = 0;
  double uncertainty = 0;  ///< >= 0; 0 where none was stated

  friend bool operator==(const Quantity&, const Quantity&) = default;
};

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

/// Reads "0.2176", "217.6 g", "217.6 ± 0.3 g", "217.6 +/- 0.3 g", "0.2176(3) kg", "5 %": a bare number is in
/// `si_unit` already. `si_unit` is the coherent SI symbol ("kg", "N/m", "rad/s", "s", "" for a plain number);
/// text with a unit of another dimension is an Error that names both: `"5 N" is a force; expected a mass, for
/// instance 217.6 g`. 1/s and rad/s are told apart: a decay rate in Hz or rad/s is refused, a frequency in
/// 1/s too. With `si_unit` "Hz" the number counts samples per second
/// ("100", "100 Hz", "100 1/s"). Not-finite numbers, decimal commas and negative uncertainties are errors.
Result<Quantity> parse_quantity(std::string_view text, std::string_view si_unit);

/// "17.04 ± 0.02 N/m" in the words of look/LOOK.md: the ± at two digits if it begins with 1 or 2, else at
/// one; the value to the same place; true minus sign; no-break spaces. Without uncertainty: six significant
/// digits at most, trailing zeros dropped.
std::string format_quantity(Quantity quantity, std::string_view unit);

/// "0.00984(3) 1/s": the uncertainty in units of the value's last digit, for tables where it would crowd the
/// number. Where that has no sense (no uncertainty, or one of 10 and more) as format_quantity.
std::string format_concise(Quantity quantity, std::string_view unit);

/// The shortest text that reads back as the same double; "nan" and "inf" as such.
std::string shortest(double value);

/// `digits` significant digits, without exponent from 1e-4 to 1e6, true minus sign; for people.
std::string rounded(double value, int digits);

}  // namespace cromer
