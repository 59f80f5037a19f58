#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "cromer/model/terms/term.h"

namespace cromer::core {

/// How powers are written: "m^2", as typed, or "m²".
enum class Powers { caret, superscript };

/// "m/s²" and "1/(m² s)" from powers of units, up to the fifth; units without a name are left out.
inline std::string unit_of_powers(std::initializer_list<std::pair<std::string_view, int>> factors,
                                  Powers powers = Powers::superscript) {
  constexpr std::string_view superscripts[] = {"", "", "²", "³", "⁴", "⁵"};
  std::string above, below;
  int count_below = 0;
  for (const auto& [name, exponent] : factors) {
    if (name.empty() || exponent == 0) continue;
    const int power = exponent > 0 ? exponent : -exponent;
    std::string& side = exponent > 0 ? above : below;
    side += (side.empty() ? "" : " ") + std::string(name);
    if (power > 1)
      side += powers == Powers::caret ? "^" + std::to_string(power) : std::string(superscripts[power]);
    count_below += exponent < 0;
  }
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + "/" + (count_below > 1 ? "(" + below + ")" : below);
}

/// The SI unit of a coefficient: "N/m^3", "kg/(m^2 s)"; "1/m" of one that is not a force's.
inline std::string unit_of(const CoefficientInfo& info, Powers powers = Powers::caret) {
  if (info.fitted == FittedAs::not_a_force)
    return unit_of_powers({{"m", info.length}, {"s", info.time}}, powers);
  if (info.time == 0) return unit_of_powers({{"N", 1}, {"m", info.length}}, powers);
  // With times in it, in kilograms: N = kg m/s^2.
  return unit_of_powers({{"kg", 1}, {"m", 1 + info.length}, {"s", info.time - 2}}, powers);
}

}  // namespace cromer::core
