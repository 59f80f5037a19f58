// Numbers with uncertainty and unit. SI units inside; text only where a person wrote it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <cromer/export.h>
#include <cromer/result.h>

namespace cromer {

/// A value and its standard uncertainty (k = 1), both in the coherent SI unit of whatever it measures; angles
/// in rad.
struct Quantity {
  double value = 0;
  double uncertainty = 0;  ///< >= 0; 0 where none was stated

  friend bool operator==(const Quantity&, const Quantity&) = default;
};

/// A quantity that may be left out: `.mass = 0.2176`, `.mass = {0.2176, 0.0003}`, or nothing.
struct OptionalQuantity : std::optional<Quantity> {
  using std::optional<Quantity>::optional;
  constexpr OptionalQuantity(double value, double uncertainty = 0)  // NOLINT: implicit on purpose
      : std::optional<Quantity>(Quantity{value, uncertainty}) {}
};

/// One estimated number.
struct Estimate {
  double value = 0;
  double standard_error = 0;  ///< widened for correlated residuals
  double low = 0, high = 0;   ///< 95 % interval from Student's t, cut at 0 where nothing below is possible
};

/// An estimate with its name, as the documents call it ("decay_rate"), and its SI unit ("1/s"; "1" or ""
/// where it is a plain number).
struct Parameter {
  std::string name;
  Estimate estimate;
  std::string unit;
};

/// Reads "0.2176", "217.6 g", "217.6 ± 0.3 g", "217.6 +/- 0.3 g", "0.2176(3) kg", "5 %": a bare number is in
/// `si_unit` already. `si_unit` is the coherent SI symbol ("kg", "N/m", "rad/s", "s", "" for a plain number);
/// text with a unit of another dimension is an Error that names both: `"5 N" is a force; expected a mass, for
/// instance 217.6 g`. 1/s and rad/s are told apart: a decay rate in Hz or rad/s is refused, a frequency in
/// 1/s too. With `si_unit` "Hz" the number counts samples per second
/// ("100", "100 Hz", "100 1/s"). Not-finite numbers, decimal commas and negative uncertainties are errors.
CROMER_API Result<Quantity> parse_quantity(std::string_view text, std::string_view si_unit);

/// "17.04 ± 0.02 N/m": the ± at two digits if it begins with 1 or 2, else at one; the value to the same
/// place; true minus sign; no-break spaces. Without uncertainty: six significant digits at most, trailing
/// zeros dropped.
CROMER_API std::string format_quantity(Quantity quantity, std::string_view unit);

}  // namespace cromer
