#pragma once

#include <string>

#include "cromer/model/terms/term.h"

namespace cromer {

/// The SI unit of a coefficient: "N/m^3", "kg/(m^2 s)"; "1/m" of one that is none of a force.
inline std::string unit_of(const CoefficientInfo& info) {
  const auto power = [](std::string_view unit, int exponent) {
    return std::string(unit) + (exponent > 1 ? "^" + std::to_string(exponent) : "");
  };
  // With times in it, in kilograms: N = kg m/s^2.
  const bool in_newtons = info.fitted != FittedAs::with_any_mass && info.time == 0;
  const bool in_kilograms = info.fitted != FittedAs::with_any_mass && info.time != 0;
  const int metres = info.length + (in_kilograms ? 1 : 0), seconds = info.time - (in_kilograms ? 2 : 0);
  std::string above = in_newtons ? "N" : in_kilograms ? "kg" : "", below;
  for (const auto& [unit, exponent] : {std::pair{"m", metres}, std::pair{"s", seconds}}) {
    std::string& side = exponent > 0 ? above : below;
    if (exponent != 0) side += (side.empty() ? "" : " ") + power(unit, exponent > 0 ? exponent : -exponent);
  }
  if (below.empty()) return above;
  const bool several = below.find(' ') != std::string::npos;
  return (above.empty() ? "1" : above) + "/" + (several ? "(" + below + ")" : below);
}

}  // namespace cromer
