// Reading a quantity: number, uncertainty, unit.
#include "cromer/base/quantity.h"

#include <array>
#include <cmath>
#include <optional>

#include "cromer/base/ascii.h"
#include "cromer/base/number.h"

namespace cromer::core {
namespace {

/// What an SI unit measures, as a notice, with examples to follow.
struct Kind {
  std::string_view si_unit;
  const char* code;
  std::string_view example, other{};
};

constexpr std::array kinds{
    Kind{"", "a_plain_number", "0.05", "5 %"},
    Kind{"kg", "a_mass", "217.6 g"},
    Kind{"N/m", "a_stiffness", "16.6 N/m"},
    Kind{"kg/s", "a_damping", "0.02 kg/s"},
    Kind{"kg/m", "a_drag", "0.02 kg/m"},
    Kind{"N", "a_force", "1.5 N"},
    Kind{"N/m^3", "a_cubic_stiffness", "20 N/m^3"},
    Kind{"N/m^2", "a_quadratic_stiffness", "20 N/m^2"},
    Kind{"N/m^5", "a_quintic_stiffness", "20 N/m^5"},
    Kind{"kg/(m^2 s)", "a_growing_damping", "2 kg/(m^2 s)"},
    Kind{"m", "a_length", "12 cm"},
    Kind{"m/s", "a_velocity", "0.3 m/s"},
    Kind{"m/s^2", "an_acceleration", "9.81 m/s^2"},
    Kind{"s", "a_time", "20 ms"},
    Kind{"rad", "an_angle", "30 deg"},
    Kind{"rad/s", "a_frequency", "3 rad/s", "0.5 Hz"},
    Kind{"1/s", "a_rate", "0.01 1/s"},
    Kind{"K", "a_temperature", "20 °C"},
    Kind{"J", "an_energy", "5 mJ"},
    Kind{"V", "a_voltage", "5 mV"},
    Kind{"Pa", "a_pressure", "1013 hPa"},
};

constexpr Dimension per_second{.second = -1};

Notice expectation(std::string_view si_unit) {
  if (si_unit == "Hz") return Notice{"expected_rate"};
  for (const Kind& kind : kinds) {
    if (kind.si_unit != si_unit) continue;
    std::vector<std::string> examples{std::string(kind.example)};
    if (!kind.other.empty()) examples.emplace_back(kind.other);
    return Notice{"expected_kind", {{"kind", Notice(kind.code)}, {"examples", std::move(examples)}}};
  }
  return Notice{"expected_in_unit", {{"unit", si_unit}}};
}

Notice kind_of(const Dimension& dimension, std::string_view unit) {
  for (const Kind& kind : kinds) {
    const auto known = parse_unit(kind.si_unit);
    if (known && known->dimension == dimension) return Notice(kind.code);
  }
  return Notice{"in_unit", {{"unit", unit}}};
}

/// Reads from the front of a text, blanks skipped before every token.
struct Reader {
  std::string_view rest;

  void skip_blanks() {
    for (bool found = true; found;) {
      found = false;
      for (const std::string_view blank : quantity_blanks)
        if (rest.starts_with(blank)) {
          rest.remove_prefix(blank.size());
          found = true;
        }
    }
  }
  bool take(std::string_view token) {
    const std::string_view before = rest;
    skip_blanks();
    if (rest.starts_with(token)) {
      rest.remove_prefix(token.size());
      return true;
    }
    rest = before;
    return false;
  }
  bool take_plus_minus() { return take("±") || take("+/-") || take("+-") || take("+/\u2212"); }
};

/// What the text says before units are applied.
struct Written {
  double value = 0, uncertainty = 0;
  std::string_view unit, uncertainty_unit;
};

/// The uncertainty of "0.2176(3)": the digits in brackets count in the last place written.
std::optional<double> concise_uncertainty(std::string_view number, std::string_view bracket) {
  const std::size_t point = number.find('.');
  const std::size_t places = point == std::string_view::npos ? 0 : number.size() - point - 1;
  if (bracket.empty() || bracket.size() > 15 || number.find_first_of("eE") != std::string_view::npos)
    return std::nullopt;
  const bool pointed = bracket.find('.') != std::string_view::npos;
  for (const char c : bracket)
    if (!is_digit(c) && c != '.') return std::nullopt;
  std::string text(bracket);
  if (!pointed) text += "e-" + std::to_string(places);  // 12.3(1.2) says 1.2 itself
  const auto read = leading_number(text);
  if (!read || read->length != text.size()) return std::nullopt;
  return read->value;
}

/// " × 10⁻⁵", " x 10^-5", "e-5" after a bracket; the power of ten, 0 where none is written.
std::optional<int> take_power_of_ten(Reader& reader, bool bracketed) {
  Reader ahead = reader;
  bool superscript = false;
  if (ahead.take("\u00d7") || ahead.take("x") || ahead.take("*")) {
    if (!ahead.take("10")) return 0;
    superscript = !ahead.take("^");
  } else if (!(bracketed && (ahead.take("e") || ahead.take("E")))) {
    return 0;
  }
  const bool negative = ahead.take("\u207b") || ahead.take("-") || ahead.take("\u2212");
  if (!negative) ahead.take("+");
  int power = 0, count = 0;
  for (bool found = true; found && count < 4;) {
    found = false;
    for (int digit = 0; digit < 10; ++digit) {
      const std::string plain(1, static_cast<char>('0' + digit));
      if (!ahead.take(superscript ? superscript_digits[static_cast<std::size_t>(digit)]
                                  : std::string_view(plain)))
        continue;
      power = 10 * power + digit;
      ++count;
      found = true;
      break;
    }
  }
  if (count == 0) return std::nullopt;
  reader = ahead;
  return negative ? -power : power;
}

Result<double> take_number(Reader& reader, std::string_view whole) {
  reader.skip_blanks();
  const auto number = leading_number(reader.rest);
  if (!number) return Error{"not_a_number", {{"text", whole}}};
  reader.rest.remove_prefix(number->length);
  if (!std::isfinite(number->value)) return Error{"too_large", {{"text", whole}}};
  if (reader.rest.size() > 1 && reader.rest[0] == ',' && is_digit(reader.rest[1])) {
    std::string cure(whole);
    for (std::size_t i = 1; i + 1 < cure.size(); ++i)
      if (cure[i] == ',' && is_digit(cure[i - 1]) && is_digit(cure[i + 1])) cure[i] = '.';
    return Error{"has_decimal_comma", {{"text", whole}, {"cure", cure}}};
  }
  return number->value;
}

double times_power_of_ten(double value, int power) {
  return power < 0 ? value / std::pow(10.0, -power) : value * std::pow(10.0, power);
}

Result<Written> read(std::string_view text) {
  Written written;
  Reader reader{text};
  const bool bracketed = reader.take("(");
  reader.skip_blanks();
  const std::string_view from = reader.rest;
  auto value = take_number(reader, text);
  if (!value) return value.error();
  written.value = *value;
  const std::string_view digits = from.substr(0, from.size() - reader.rest.size());

  bool concise = false;
  if (reader.take("(")) {
    const std::size_t end = reader.rest.find(')');
    const auto uncertainty = concise_uncertainty(digits, reader.rest.substr(0, end));
    if (end == std::string_view::npos || !uncertainty)
      return Error{"bad_concise_uncertainty", {{"text", text}}};
    written.uncertainty = *uncertainty;
    reader.rest.remove_prefix(end + 1);
    concise = true;
  }
  auto read_uncertainty = [&]() -> Result<void> {
    auto uncertainty = take_number(reader, text);
    if (!uncertainty) return uncertainty.error();
    if (*uncertainty < 0) return Error{"negative_uncertainty", {{"text", text}}};
    written.uncertainty = *uncertainty;
    return {};
  };
  bool stated = concise;
  if (!stated && reader.take_plus_minus()) {
    if (auto done = read_uncertainty(); !done) return done.error();
    stated = true;
  }
  if (bracketed && !reader.take(")")) return Error{"no_closing_bracket", {{"text", text}}};
  const auto power = take_power_of_ten(reader, bracketed || concise);
  if (!power || std::abs(*power) > 400) return Error{"no_power_of_ten", {{"text", text}}};
  written.value = times_power_of_ten(written.value, *power);
  written.uncertainty = times_power_of_ten(written.uncertainty, *power);

  // What is left is the unit, or "g ± 0.3 g".
  std::size_t sign = std::string_view::npos;
  if (!stated)
    for (const std::string_view token :
         {std::string_view("±"), std::string_view("+/-"), std::string_view("+-")})
      sign = std::min(sign, reader.rest.find(token));
  written.unit = reader.rest.substr(0, sign);
  if (sign != std::string_view::npos) {
    reader.rest.remove_prefix(sign);
    reader.take_plus_minus();
    if (auto done = read_uncertainty(); !done) return done.error();
    written.uncertainty_unit = reader.rest;
  }
  return written;
}

/// Division by a whole power of ten rounds once, where multiplying by 1e-3 would round twice.
double scaled(double number, double factor) { return factor < 1 ? number / (1 / factor) : number * factor; }

}  // namespace

}  // namespace cromer::core

namespace cromer {

using namespace core;

Result<Quantity> parse_quantity(std::string_view text, std::string_view si_unit) {
  const auto target = parse_unit(si_unit);
  if (!target) return target.error();
  auto refuse = [&](Notice reason) {
    return Error{"quantity_refused", {{"what", std::move(reason)}, {"expected", expectation(si_unit)}}};
  };

  auto written = read(text);
  if (!written) return refuse(written.error().notice);
  const auto trimmed = [](std::string_view unit) {
    Reader reader{unit};
    reader.skip_blanks();
    return reader.rest;
  };
  auto unit_of = [&](std::string_view spelled) -> Result<Unit> {
    auto unit = parse_unit(spelled, &target->dimension);
    if (!unit) return refuse(Notice{"in_text", {{"text", text}, {"what", unit.error().notice}}});
    const bool samples =
        si_unit == "Hz" && unit->dimension == per_second;  // 1/s counts samples as well as Hz does
    if (samples) return Unit{target->factor * unit->factor, 0, target->dimension};
    if (unit->dimension != target->dimension)
      return refuse(Notice{"of_other_kind", {{"text", text}, {"kind", kind_of(unit->dimension, spelled)}}});
    return unit;
  };

  Unit unit = *target;
  unit.offset = 0;
  if (!trimmed(written->unit).empty()) {
    auto read_unit = unit_of(trimmed(written->unit));
    if (!read_unit) return read_unit.error();
    unit = *read_unit;
  }
  double uncertainty_factor = unit.factor;
  if (!trimmed(written->uncertainty_unit).empty()) {
    auto read_unit = unit_of(trimmed(written->uncertainty_unit));
    if (!read_unit) return read_unit.error();
    uncertainty_factor = read_unit->factor;
    if (trimmed(written->unit).empty()) unit = *read_unit;
  }
  const Quantity quantity{scaled(written->value, unit.factor / target->factor) + unit.offset,
                          scaled(written->uncertainty, uncertainty_factor / target->factor)};
  if (!std::isfinite(quantity.value) || !std::isfinite(quantity.uncertainty))
    return refuse(Notice{"too_large", {{"text", text}}});
  return quantity;
}

}  // namespace cromer
