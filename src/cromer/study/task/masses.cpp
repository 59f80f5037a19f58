#include "cromer/study/task/masses.h"

#include <string>

#include "cromer/base/ascii.h"

namespace cromer {
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
  std::string unit;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    if (part->empty()) return Error{"--masses: a mass is missing between two commas"};
    if (const auto own = unit_in(*part); !own.empty())
      unit = own;
    else if (!unit.empty())
      *part += " " + unit;
  }
  std::vector<Quantity> masses;
  for (const std::string& part : parts) {
    const auto mass = parse_quantity(part, "kg");
    if (!mass) return Error{"--masses: " + mass.error().message};
    if (!(mass->value >= 0)) return Error{"--masses: " + part + " is negative"};
    masses.push_back(*mass);
  }
  return masses;
}

}  // namespace cromer
