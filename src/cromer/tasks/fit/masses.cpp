#include "cromer/tasks/fit/masses.h"

#include <string>

#include "cromer/base/ascii.h"

namespace cromer::core {
namespace {

/// What follows the last digit or bracket: "g" of "48.4(2) g".
std::string_view unit_in(std::string_view part) {
  const auto last = part.find_last_of("0123456789)");
  return last == std::string_view::npos ? std::string_view{} : trimmed(part.substr(last + 1));
}

}  // namespace

Result<std::vector<Quantity>> parse_masses(std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0;;) {
    const auto end = text.find(',', begin);
    parts.emplace_back(trimmed(text.substr(begin, end == std::string_view::npos ? end : end - begin)));
    if (end == std::string_view::npos) break;
    begin = end + 1;
  }
  std::size_t with_unit = 0;
  for (const std::string& part : parts) {
    if (part.empty()) return Error{"mass_missing"};
    with_unit += !unit_in(part).empty();
  }
  // One unit at the end is that of all; some with and some without one could mean anything.
  const std::string unit(unit_in(parts.back()));
  for (std::string& part : parts) {
    if (with_unit == parts.size() || with_unit == 0 || !unit_in(part).empty()) continue;
    if (with_unit > 1 || unit.empty()) return Error{"mass_without_unit", {{"mass", part}}};
    part += " " + unit;
  }
  std::vector<Quantity> masses;
  for (const std::string& part : parts) {
    const auto mass = parse_quantity(part, "kg");
    if (!mass) return Error{"of_masses", {{"what", mass.error().notice}}};
    if (!(mass->value >= 0)) return Error{"mass_negative", {{"mass", part}}};
    masses.push_back(*mass);
  }
  return masses;
}

}  // namespace cromer::core
