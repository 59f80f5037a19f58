// A part of a whole, for a terminal.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace cromer::core {

/// "5.8 %": two digits, whole percents from 100 on; "0 %" where only rounding is left.
inline std::string percent(double part) {
  if (std::abs(part) < 1e-12) return "0 %";
  return std::abs(part) < 0.995 ? fmt::format("{:.2g} %", 100 * part) : fmt::format("{:.0f} %", 100 * part);
}

/// The same with its sign: "+5.8 %".
inline std::string percent_off(double part) { return (part >= 1e-12 ? "+" : "") + percent(part); }

}  // namespace cromer::core
