// The units Cromer knows and the grammar that joins them.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>

#include "cromer/base/ascii.h"
#include "cromer/base/number.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantity.h"

namespace cromer::core {
namespace {

struct Symbol {
  std::string_view text;
  double factor;
  Dimension dimension;
  bool prefixed = false;  ///< takes SI prefixes
};

constexpr double degree = std::numbers::pi / 180;
constexpr double cycle = two_pi;
constexpr double gravity = 9.80665;      // [m/s^2] standard acceleration, 3rd CGPM (1901)
constexpr double zero_celsius = 273.15;  // [K]

constexpr Dimension none{};
constexpr Dimension acceleration{.metre = 1, .second = -2};

// kg, m, s, K, A, rad in the order of Dimension.
constexpr std::array symbols{
    Symbol{"g", 1e-3, {1}, true},
    Symbol{"m", 1, {0, 1}, true},
    Symbol{"s", 1, {0, 0, 1}, true},
    Symbol{"sec", 1, {0, 0, 1}},
    Symbol{"min", 60, {0, 0, 1}},
    Symbol{"h", 3600, {0, 0, 1}},
    // As people, loggers and Arduino sketches spell them out.
    Symbol{"gram", 1e-3, {1}},
    Symbol{"grams", 1e-3, {1}},
    Symbol{"Gramm", 1e-3, {1}},
    Symbol{"kilogram", 1, {1}},
    Symbol{"kilograms", 1, {1}},
    Symbol{"Kilogramm", 1, {1}},
    Symbol{"secs", 1, {0, 0, 1}},
    Symbol{"second", 1, {0, 0, 1}},
    Symbol{"seconds", 1, {0, 0, 1}},
    Symbol{"msec", 1e-3, {0, 0, 1}},
    Symbol{"msecs", 1e-3, {0, 0, 1}},
    Symbol{"millis", 1e-3, {0, 0, 1}},
    Symbol{"millisecond", 1e-3, {0, 0, 1}},
    Symbol{"milliseconds", 1e-3, {0, 0, 1}},
    Symbol{"usec", 1e-6, {0, 0, 1}},
    Symbol{"usecs", 1e-6, {0, 0, 1}},
    Symbol{"micros", 1e-6, {0, 0, 1}},
    Symbol{"microsecond", 1e-6, {0, 0, 1}},
    Symbol{"microseconds", 1e-6, {0, 0, 1}},
    Symbol{"mins", 60, {0, 0, 1}},
    Symbol{"minute", 60, {0, 0, 1}},
    Symbol{"minutes", 60, {0, 0, 1}},
    Symbol{"hr", 3600, {0, 0, 1}},
    Symbol{"hrs", 3600, {0, 0, 1}},
    Symbol{"hour", 3600, {0, 0, 1}},
    Symbol{"hours", 3600, {0, 0, 1}},
    Symbol{"K", 1, {0, 0, 0, 1}, true},
    Symbol{"A", 1, {0, 0, 0, 0, 1}, true},
    Symbol{"N", 1, {1, 1, -2}, true},
    Symbol{"J", 1, {1, 2, -2}, true},
    Symbol{"W", 1, {1, 2, -3}, true},
    Symbol{"Pa", 1, {1, -1, -2}, true},
    Symbol{"V", 1, {1, 2, -3, 0, -1}, true},
    Symbol{"T", 1, {1, 0, -2, 0, -1}, true},
    Symbol{"Hz", cycle, {0, 0, -1, 0, 0, 1}, true},
    Symbol{"rpm", cycle / 60, {0, 0, -1, 0, 0, 1}},
    Symbol{"rad", 1, {0, 0, 0, 0, 0, 1}, true},
    Symbol{"deg", degree, {0, 0, 0, 0, 0, 1}},
    Symbol{"°", degree, {0, 0, 0, 0, 0, 1}},
    Symbol{"degree", degree, {0, 0, 0, 0, 0, 1}},
    Symbol{"degrees", degree, {0, 0, 0, 0, 0, 1}},
    Symbol{"Grad", degree, {0, 0, 0, 0, 0, 1}},  // in German; no unit of giga-radians is meant
    Symbol{"radian", 1, {0, 0, 0, 0, 0, 1}},
    Symbol{"radians", 1, {0, 0, 0, 0, 0, 1}},
    Symbol{"in", 0.0254, {0, 1}},
    Symbol{"ft", 0.3048, {0, 1}},
    Symbol{"Gal", 1e-2, acceleration, true},
    Symbol{"gal", 1e-2, acceleration},  // as seismologists write it
    Symbol{"gn", gravity, acceleration},
    Symbol{"%", 0.01, none},
    Symbol{"1", 1, none},
    Symbol{"°C", 1, {0, 0, 0, 1}},
    Symbol{"degC", 1, {0, 0, 0, 1}},
};

struct Prefix {
  std::string_view text;
  double factor;
};

constexpr std::array prefixes{
    Prefix{"p", 1e-12},     Prefix{"n", 1e-9}, Prefix{"u", 1e-6}, Prefix{"\u00b5", 1e-6},
    Prefix{"\u03bc", 1e-6}, Prefix{"m", 1e-3}, Prefix{"c", 1e-2}, Prefix{"d", 1e-1},
    Prefix{"h", 1e2},       Prefix{"k", 1e3},  Prefix{"M", 1e6},  Prefix{"G", 1e9},
};

/// 1 without a prefix.
std::optional<double> prefix_factor(std::string_view text) {
  if (text.empty()) return 1;
  for (const Prefix& prefix : prefixes)
    if (prefix.text == text) return prefix.factor;
  return std::nullopt;
}

/// Of what stands before the g of gravity: a prefix below 1, or a percent sign.
std::optional<double> part_of_gravity(std::string_view text) {
  const auto factor = text == "%" ? std::optional(0.01) : prefix_factor(text);
  return factor && *factor <= 1 ? factor : std::nullopt;
}

std::optional<Symbol> find_symbol(std::string_view text) {
  for (const Symbol& symbol : symbols)
    if (symbol.text == text) return symbol;
  for (const Prefix& prefix : prefixes) {
    if (!text.starts_with(prefix.text)) continue;
    for (const Symbol& symbol : symbols) {
      if (!symbol.prefixed || symbol.text != text.substr(prefix.text.size())) continue;
      const bool kilogram = symbol.text == "g" && prefix.text == "k";  // 1, not 1e3 * 1e-3
      return Symbol{text, kilogram ? 1 : prefix.factor * symbol.factor, symbol.dimension};
    }
  }
  return std::nullopt;
}

/// Reads from the front of a text.
struct UnitReader {
  std::string_view rest;

  bool take(std::string_view token) {
    if (!rest.starts_with(token)) return false;
    rest.remove_prefix(token.size());
    return true;
  }

  bool take_blank() {
    return std::any_of(quantity_blanks.begin(), quantity_blanks.end(),
                       [this](std::string_view blank) { return take(blank); });
  }

  void skip_blanks() {
    while (take_blank()) {
    }
  }
};

std::optional<int> take_digit(UnitReader& reader) {
  if (!reader.rest.empty() && is_digit(reader.rest[0])) {
    const int digit = reader.rest[0] - '0';
    reader.rest.remove_prefix(1);
    return digit;
  }
  for (std::size_t digit = 0; digit < superscript_digits.size(); ++digit)
    if (reader.take(superscript_digits[digit])) return static_cast<int>(digit);
  return std::nullopt;
}

/// "^-2", "²", "⁻¹" or the bare digit of "m/s2"; 1 where no power is written, nothing where it is malformed.
/// At most one digit.
std::optional<int> take_power(UnitReader& reader) {
  const bool caret = reader.take("^");
  bool negative = reader.take("\u207b");
  UnitReader ahead = reader;
  if (!negative && (ahead.take("-") || ahead.take("\u2212")) &&
      (caret || (!ahead.rest.empty() && is_digit(ahead.rest[0])))) {
    negative = true;
    reader = ahead;
  }
  const std::optional<int> power = take_digit(reader);
  if (!power && !caret && !negative) return 1;
  if (!power || *power == 0 || take_digit(reader)) return std::nullopt;
  return negative ? -*power : *power;
}

bool ends_symbol(std::string_view rest) {
  constexpr std::array<std::string_view, 9> ends{")",      "/",      "*",      "^",     "-",
                                                 "\u00b7", "\u22c5", "\u2212", "\u207b"};
  const auto begins = [rest](std::string_view token) { return rest.starts_with(token); };
  if (std::any_of(ends.begin(), ends.end(), begins) ||
      std::any_of(quantity_blanks.begin(), quantity_blanks.end(), begins) ||
      std::any_of(superscript_digits.begin(), superscript_digits.end(), begins))
    return true;
  return is_digit(rest[0]);
}

std::string_view take_symbol(UnitReader& reader) {
  if (reader.rest.starts_with('1')) {
    const std::string_view one = reader.rest.substr(0, 1);
    reader.rest.remove_prefix(1);
    return one;
  }
  std::size_t length = 0;
  while (length < reader.rest.size() && !ends_symbol(reader.rest.substr(length))) ++length;
  const std::string_view symbol = reader.rest.substr(0, length);
  reader.rest.remove_prefix(length);
  return symbol;
}

bool multiply(Dimension& dimension, const Dimension& other, int power) {
  constexpr std::array parts{&Dimension::kilogram, &Dimension::metre,  &Dimension::second,
                             &Dimension::kelvin,   &Dimension::ampere, &Dimension::radian};
  for (const auto part : parts) {
    const int exponent = dimension.*part + power * (other.*part);
    if (std::abs(exponent) > 100) return false;
    dimension.*part = static_cast<signed char>(exponent);
  }
  return true;
}

}  // namespace

Result<Unit> parse_unit(std::string_view text, const Dimension* expected) {
  const auto unknown = [](std::string_view spelled) { return Error{"unknown_unit", {{"unit", spelled}}}; };
  UnitReader reader{text};
  reader.skip_blanks();
  while (!reader.rest.empty() && reader.rest.back() == ' ') reader.rest.remove_suffix(1);
  if (expected && *expected == acceleration && reader.rest.ends_with('g'))
    if (const auto factor = part_of_gravity(reader.rest.substr(0, reader.rest.size() - 1)))
      return Unit{*factor * gravity, 0, acceleration};
  // A tonne where a mass is asked for: elsewhere "t" is a time without a unit.
  constexpr Dimension mass{1};
  if (reader.rest == "t" && expected && *expected == mass) return Unit{1e3, 0, mass};
  if (reader.rest == "°C" || reader.rest == "degC") return Unit{1, zero_celsius, {.kelvin = 1}};

  Unit unit;
  // A bracket is divided by as a whole: "kg/(m^2 s)".
  int sign = 1, outside = 1;
  bool in_brackets = false;
  bool wanted = !reader.rest.empty();
  while (wanted) {
    if (sign < 0 && !in_brackets && reader.take("(")) {
      in_brackets = true;
      outside = -1;
      reader.skip_blanks();
    }
    const std::string_view name = take_symbol(reader);
    const auto symbol = find_symbol(name);
    if (!symbol) return unknown(name.empty() ? text : name);
    const auto power = name == "1" ? std::optional<int>(1) : take_power(reader);
    if (!power || !multiply(unit.dimension, symbol->dimension, sign * *power)) return unknown(text);
    // Only products of small whole powers, so that kg m/s^2 is exactly 1.
    for (int i = 0; i < std::abs(*power); ++i)
      unit.factor = sign * *power > 0 ? unit.factor * symbol->factor : unit.factor / symbol->factor;
    reader.skip_blanks();
    if (in_brackets && reader.take(")")) {
      in_brackets = false;
      outside = 1;
      reader.skip_blanks();
    }
    if (reader.rest.empty()) break;
    const bool divided = reader.take("/");
    sign = divided ? -outside : outside;
    if (!divided && !reader.take("*") && !reader.take("\u00b7")) reader.take("\u22c5");
    reader.skip_blanks();
  }
  if (in_brackets || !(unit.factor > 0) || !std::isfinite(unit.factor)) return unknown(text);
  return unit;
}

}  // namespace cromer::core
