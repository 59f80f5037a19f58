// What a column measures, from its name and unit.
#pragma once

#include <string>
#include <string_view>

#include "cromer/base/table.h"
#include "cromer/notice.h"

namespace cromer::core {

/// What a column measures: time, position, angle, velocity, angular velocity, acceleration, force, voltage or
/// frequency; "" if neither its unit nor its name (English, German, Italian, French or Spanish) says. A known
/// unit decides; but a column called a frequency is one in rad/s too.
std::string quantity_of(std::string_view name, std::string_view unit);

/// Whether a unit is known and measures the quantity.
bool is_unit_of(std::string_view unit, std::string_view quantity);

/// The unit of time, if the whole name is one: ms of "millis", s of "seconds"; else "".
std::string_view unit_as_name(std::string_view name);

/// The SI value of 1 in the column's unit; `known` is false where the unit is missing or unknown (then 1 is
/// returned).
struct ToSi {
  double factor = 1;
  bool known = true;
};
ToSi to_si(const Column& column);

/// The SI unit of a quantity ("m" of a position, Hz of a frequency); "" if it is not one of those above.
std::string_view si_unit_of(std::string_view quantity);

/// What a column holds, as a part of a sentence.
Notice kind_of(std::string_view quantity);

/// Lower case, without blanks, brackets, underscores, braces, backslashes and dollars: "x_{1}" is "x1".
std::string plain_name(std::string_view name);

}  // namespace cromer::core
