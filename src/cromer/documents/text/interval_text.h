// A 95 % interval in words.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace cromer::core {

/// "between 19.99912 and 20.00054", with so many digits that the interval's width has three.
inline std::string interval_text(double low, double high) {
  const double size = std::max(std::abs(low), std::abs(high)), width = high - low;
  const bool plain = std::isfinite(size) && std::isfinite(width) && size > 0 && width > 0;
  const int digits = plain ? std::clamp(static_cast<int>(std::ceil(std::log10(size / width))) + 3, 4, 15) : 4;
  return fmt::format("between {:.{}g} and {:.{}g}", low, digits, high, digits);
}

}  // namespace cromer::core
