// Numbers written for people, and the shortest text for programs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "cromer/base/number.h"
#include "cromer/base/quantity.h"

namespace cromer::core {
namespace {

constexpr std::string_view true_minus = "\u2212";
constexpr std::string_view no_break_space = "\u00a0";

/// A rounded number without its sign, digits × 10^place; digits is a whole number, "0" if nothing is left.
struct Decimal {
  std::string digits;
  int place = 0;

  int exponent() const { return digits == "0" ? place : place + static_cast<int>(digits.size()) - 1; }
};

/// `count` significant digits, correctly rounded from the exact value of the double.
Decimal significant(double value, int count) {
  if (value == 0) return {"0", 0};
  const std::string text = fmt::format("{:.{}e}", std::fabs(value), count - 1);
  const std::size_t e = text.find('e');
  Decimal decimal;
  for (const char c : text.substr(0, e))
    if (c != '.') decimal.digits += c;
  int exponent = 0;
  const char* first = text.data() + e + (text[e + 1] == '+' ? 2 : 1);
  std::from_chars(first, text.data() + text.size(), exponent);
  decimal.place = exponent - (count - 1);
  return decimal;
}

/// Rounded to a multiple of 10^place.
Decimal rounded_to(double value, int place) {
  const int count = significant(value, 17).exponent() - place + 1;
  if (value == 0 || count < 0) return {"0", place};
  if (count == 0) {
    const bool up = significant(value, 17).digits[0] >= '5';
    return {up ? "1" : "0", place};
  }
  Decimal decimal = significant(value, count);
  if (decimal.place > place) decimal.digits += '0';  // 9.96 to one place has become 10.0
  decimal.place = place;
  return decimal;
}

/// digits × 10^shift with a point, no exponent.
std::string fixed(const std::string& digits, int shift) {
  if (shift >= 0) return digits == "0" ? digits : digits + std::string(static_cast<std::size_t>(shift), '0');
  const std::size_t decimals = static_cast<std::size_t>(-shift);
  const std::size_t zeros = digits.size() <= decimals ? decimals + 1 - digits.size() : 0;
  const std::string padded = std::string(zeros, '0') + digits;
  const std::size_t point = padded.size() - decimals;
  return fmt::format("{}.{}", std::string_view(padded).substr(0, point),
                     std::string_view(padded).substr(point));
}

/// With a minus sign if the value is negative and any digit other than 0 is left.
std::string signed_text(bool negative, const std::string& text) {
  const bool zero = text.find_first_of("123456789") == std::string::npos;
  return negative && !zero ? std::string(true_minus) + text : text;
}

bool needs_power(int exponent) { return exponent < -4 || exponent >= 6; }

std::string not_finite(double value) {
  if (std::isnan(value)) return "nan";
  return value < 0 ? std::string(true_minus) + "inf" : "inf";
}

std::string write(double value, Decimal decimal) {
  const int exponent = decimal.exponent();
  if (!needs_power(exponent)) return signed_text(value < 0, fixed(decimal.digits, decimal.place));
  return signed_text(value < 0, fixed(decimal.digits, decimal.place - exponent)) + power_of_ten(exponent);
}

/// The last place an uncertainty is quoted to: two digits if it begins with 1 or 2, else one.
int last_place(double uncertainty) {
  const Decimal two = significant(uncertainty, 2);
  if (two.digits[0] == '1' || two.digits[0] == '2') return two.place;
  const Decimal one = significant(uncertainty, 1);
  return one.digits[0] == '1' ? one.place - 1 : one.place;  // 0.096 is 0.10
}

std::string with_unit(std::string text, std::string_view unit) {
  if (unit.empty()) return text;
  if (unit != "°") text += no_break_space;
  return text.append(unit);
}

}  // namespace

std::string power_of_ten(int exponent) {
  std::string text = fmt::format("{0}\u00d7{0}10", no_break_space);
  for (const char c : std::to_string(exponent))
    text += c == '-' ? "\u207b" : superscript_digits[static_cast<std::size_t>(c - '0')];
  return text;
}

std::string rounded(double value, int digits) {
  if (!std::isfinite(value)) return not_finite(value);
  if (value == 0) return "0";
  return write(value, significant(value, std::clamp(digits, 1, 17)));
}

std::string format_concise(Quantity quantity, std::string_view unit) {
  const double u = quantity.uncertainty;
  if (!(u > 0) || !std::isfinite(u) || !std::isfinite(quantity.value)) return format_quantity(quantity, unit);
  const int place = last_place(u);
  const Decimal value = rounded_to(quantity.value, place);
  if (place >= 0 || needs_power(value.exponent())) return format_quantity(quantity, unit);
  const std::string text = signed_text(quantity.value < 0, fixed(value.digits, place));
  return with_unit(fmt::format("{}({})", text, rounded_to(u, place).digits), unit);
}

std::string shortest(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  std::array<char, 32> text;
  return {text.data(), write_shortest(text.data(), value)};
}

std::string bytes_in_words(double bytes) {
  constexpr const char* units[] = {"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
  std::size_t unit = 0;
  for (; bytes >= 999.5 && unit + 1 < std::size(units); ++unit) bytes /= 1000;
  return fmt::format("{:.3g} {}", bytes, units[unit]);
}

}  // namespace cromer::core

namespace cromer {

using namespace core;

std::string format_quantity(Quantity quantity, std::string_view unit) {
  const auto [value, uncertainty] = quantity;
  if (!std::isfinite(value)) return with_unit(not_finite(value), unit);
  if (!(uncertainty > 0) || !std::isfinite(uncertainty)) {
    if (value == 0) return with_unit("0", unit);
    Decimal decimal = significant(value, 6);
    while (decimal.digits.size() > 1 && decimal.digits.back() == '0') {
      decimal.digits.pop_back();
      ++decimal.place;
    }
    return with_unit(write(value, decimal), unit);
  }
  const int place = last_place(uncertainty);
  const Decimal v = rounded_to(value, place);
  const Decimal u = rounded_to(uncertainty, place);
  const int exponent = std::max(v.exponent(), u.exponent());
  const bool power = needs_power(exponent);
  const int shift = power ? place - exponent : place;
  std::string text = signed_text(value < 0, fixed(v.digits, shift));
  text += fmt::format("{0}±{0}{1}", no_break_space, fixed(u.digits, shift));
  if (power) text = "(" + text + ")" + power_of_ten(exponent);
  return with_unit(text, unit);
}

}  // namespace cromer
