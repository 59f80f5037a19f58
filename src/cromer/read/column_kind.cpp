#include "cromer/read/column_kind.h"

#include <algorithm>
#include <array>
#include <vector>

#include "cromer/base/ascii.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantity.h"

namespace cromer::core {
namespace {

struct Measure {
  std::string_view quantity, si_unit;
};

constexpr std::array measures{
    Measure{"time", "s"},
    Measure{"position", "m"},
    Measure{"angle", "rad"},
    Measure{"velocity", "m/s"},
    Measure{"angular velocity", "rad/s"},
    Measure{"acceleration", "m/s²"},
    Measure{"force", "N"},
    Measure{"voltage", "V"},
    Measure{"frequency", "Hz"},  // last: a unit alone that counts angles is an angular velocity's
};

struct Word {
  std::string_view word, quantity;
};

/// Words anywhere in a name; the first that is found decides, so the narrower stand first.
constexpr std::array words{
    Word{"frequency", "frequency"},
    Word{"frequenza", "frequency"},
    Word{"frequenz", "frequency"},
    Word{"fréquence", "frequency"},
    Word{"frecuencia", "frequency"},
    Word{"freq", "frequency"},
    Word{"gyroscope", "angular velocity"},
    Word{"gyro", "angular velocity"},
    Word{"giroscopio", "angular velocity"},
    Word{"omega", "angular velocity"},
    Word{"ω", "angular velocity"},
    Word{"rotation", "angular velocity"},
    Word{"winkelgeschwindigkeit", "angular velocity"},
    Word{"angle", "angle"},
    Word{"angolo", "angle"},
    Word{"winkel", "angle"},
    Word{"theta", "angle"},
    Word{"θ", "angle"},
    Word{"phi", "angle"},
    Word{"φ", "angle"},
    Word{"acceleration", "acceleration"},
    Word{"accelerazione", "acceleration"},
    Word{"accélération", "acceleration"},
    Word{"aceleración", "acceleration"},
    Word{"beschleunigung", "acceleration"},
    Word{"accel", "acceleration"},
    Word{"acc", "acceleration"},
    Word{"velocity", "velocity"},
    Word{"speed", "velocity"},
    Word{"velocità", "velocity"},
    Word{"vitesse", "velocity"},
    Word{"velocidad", "velocity"},
    Word{"geschwindigkeit", "velocity"},
    Word{"position", "position"},
    Word{"pos", "position"},
    Word{"posizione", "position"},
    Word{"posición", "position"},
    Word{"displacement", "position"},
    Word{"spostamento", "position"},
    Word{"distance", "position"},
    Word{"distanza", "position"},
    Word{"abstand", "position"},
    Word{"auslenkung", "position"},
    Word{"weg", "position"},
    Word{"ort", "position"},
    Word{"elongation", "position"},
    Word{"force", "force"},
    Word{"forza", "force"},
    Word{"kraft", "force"},
    Word{"fuerza", "force"},
    Word{"voltage", "voltage"},
    Word{"potential", "voltage"},
    Word{"tensione", "voltage"},
    Word{"spannung", "voltage"},
    Word{"time", "time"},
    Word{"timestamp", "time"},
    Word{"tempo", "time"},
    Word{"zeit", "time"},
    Word{"temps", "time"},
    Word{"tiempo", "time"},
};

struct UnitName {
  std::string_view name, unit;
};

/// Units of time that may be the whole name, as Arduino's millis(); "min" is a minimum, "s" a path.
constexpr std::array time_units{
    UnitName{"millis", "ms"},       UnitName{"ms", "ms"},           UnitName{"msec", "ms"},
    UnitName{"milliseconds", "ms"}, UnitName{"micros", "us"},       UnitName{"us", "us"},
    UnitName{"usec", "us"},         UnitName{"microseconds", "us"}, UnitName{"µs", "µs"},
    UnitName{"μs", "μs"},           UnitName{"sec", "s"},           UnitName{"secs", "s"},
    UnitName{"seconds", "s"},       UnitName{"minutes", "min"},     UnitName{"hours", "h"},
};

/// Symbols that are the whole name, subscripts aside; capitals mean other things (V may be a voltage, T a
/// temperature).
constexpr std::array symbols{
    Word{"t", "time"},          Word{"x", "position"},      Word{"y", "position"},
    Word{"z", "position"},      Word{"X", "position"},      Word{"Y", "position"},
    Word{"Z", "position"},      Word{"v", "velocity"},      Word{"vx", "velocity"},
    Word{"vy", "velocity"},     Word{"vz", "velocity"},     Word{"a", "acceleration"},
    Word{"ax", "acceleration"}, Word{"ay", "acceleration"}, Word{"az", "acceleration"},
    Word{"F", "force"},
};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80; }

/// Runs of letters, in lower case.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> found;
  bool inside = false;
  for (const char letter : name) {
    const char c = lower(letter);
    if (is_letter(c)) {
      if (!inside) found.emplace_back();
      found.back() += c;
    }
    inside = is_letter(c);
  }
  return found;
}

std::string_view quantity_of_name(std::string_view name) {
  const std::vector<std::string> found = words_of(name);
  // A logger may cut a long name off: "Acceleratio".
  constexpr std::size_t long_enough = 9;
  const auto has = [&](std::string_view word) {
    return std::any_of(found.begin(), found.end(), [&](const std::string& own) {
      return own == word || (own.size() >= long_enough && word.starts_with(own));
    });
  };
  const bool angular = has("angular") || has("angolare") || has("angulaire");
  for (const Word& word : words) {
    if (!has(word.word)) continue;
    if (!angular || word.quantity == "frequency") return word.quantity;
    if (word.quantity == "velocity") return "angular velocity";
    if (word.quantity == "position") return "angle";
    return word.quantity == "angular velocity" || word.quantity == "angle" ? word.quantity
                                                                           : std::string_view{};
  }
  std::string symbol;
  for (const char c : name)
    if (std::string_view(" _{}").find(c) == std::string_view::npos) symbol += c;
  while (!symbol.empty() && is_digit(symbol.back())) symbol.pop_back();
  for (const Word& word : symbols)
    if (word.word == symbol) return word.quantity;
  return unit_as_name(name).empty() ? std::string_view{} : "time";
}

const Dimension* dimension_of(std::string_view si_unit) {
  static const auto dimensions = [] {
    std::array<Dimension, measures.size()> all{};
    for (std::size_t i = 0; i < measures.size(); ++i)
      all[i] = parse_unit(measures[i].si_unit).value().dimension;
    return all;
  }();
  for (std::size_t i = 0; i < measures.size(); ++i)
    if (measures[i].si_unit == si_unit) return &dimensions[i];
  return nullptr;
}

/// A unit in the column of a quantity: a g of acceleration is gravity, and capitals do not count in a time's
/// (MS, Sec).
Result<Unit> unit_of(std::string_view unit, std::string_view quantity) {
  const auto known = parse_unit(unit, dimension_of(si_unit_of(quantity)));
  if (known || quantity != "time") return known;
  return parse_unit(lower(unit));
}

}  // namespace

std::string_view si_unit_of(std::string_view quantity) {
  for (const Measure& measure : measures)
    if (measure.quantity == quantity) return measure.si_unit;
  return {};
}

std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name)
    if (std::string_view(" _{}[]()\\$^\t").find(c) == std::string_view::npos) plain += lower(c);
  return plain;
}

std::string_view unit_as_name(std::string_view name) {
  const std::string plain = plain_name(name);
  for (const UnitName& known : time_units)
    if (known.name == plain) return known.unit;
  return {};
}

bool is_unit_of(std::string_view unit, std::string_view quantity) {
  const Dimension* dimension = dimension_of(si_unit_of(quantity));
  const auto known = unit_of(unit, quantity);
  return dimension && known && known->dimension == *dimension;
}

std::string quantity_of(std::string_view name, std::string_view unit) {
  const std::string_view by_name = quantity_of_name(name);
  if (unit.empty()) return std::string(by_name);
  const auto known = unit_of(unit, by_name);
  if (!known) return std::string(by_name);
  const bool counts_angles = known->dimension == *dimension_of("Hz");
  if (counts_angles && by_name == "frequency") return "frequency";
  if (unit.find("Hz") != std::string_view::npos) return counts_angles ? "frequency" : "";
  for (const Measure& measure : measures)
    if (*dimension_of(measure.si_unit) == known->dimension) return std::string(measure.quantity);
  return {};
}

Notice kind_of(std::string_view quantity) {
  if (quantity == "position") return Notice{"kind_position"};
  if (quantity == "angle") return Notice{"kind_angle"};
  if (quantity == "velocity") return Notice{"kind_velocity"};
  if (quantity == "angular velocity") return Notice{"kind_angular_velocity"};
  if (quantity == "acceleration") return Notice{"kind_acceleration"};
  if (quantity == "angular acceleration") return Notice{"kind_angular_acceleration"};
  if (quantity == "force") return Notice{"kind_force"};
  if (quantity == "voltage") return Notice{"kind_voltage"};
  if (quantity == "frequency") return Notice{"kind_frequency"};
  if (quantity == "time") return Notice{"kind_time"};
  return quantity.empty() ? Notice{"kind_unknown"} : Notice{"kind_of_its_own", {{"quantity", quantity}}};
}

ToSi to_si(const Column& column) {
  if (column.unit.empty()) return {1, false};
  const auto unit = unit_of(column.unit, column.quantity);
  if (!unit) return {1, false};
  // Hz as a unit of this program counts the angle of its cycles; a column of frequencies counts cycles.
  constexpr double cycle = two_pi;  // [rad]
  return {column.quantity == "frequency" ? unit->factor / cycle : unit->factor, true};
}

}  // namespace cromer::core
