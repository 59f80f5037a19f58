// Logarithm and power to three digits, for controls that need no more: a few operations instead of some
// hundred cycles.
#pragma once

#include <cstdint>

#include "cromer/base/bit_cast.h"

namespace cromer::core {

/// log2 x, for normal x > 0. Error: below 9e-4; exact at powers of 2.
inline double coarse_log2(double x) {
  constexpr std::uint64_t mantissa = (std::uint64_t{1} << 52) - 1, one = std::uint64_t{1023} << 52;
  const auto bits = bit_cast<std::uint64_t>(x);
  const double u = bit_cast<double>((bits & mantissa) | one) - 1;
  const auto exponent = static_cast<double>(static_cast<std::int64_t>(bits >> 52) - 1023);
  // The chord from 1 to 2, and a cubic that vanishes at both.
  return (exponent + u) + (u * (u - 1)) * (u * 0.15922 - 0.422865);
}

/// 2^y; y below -1000 or above 1000 counts as that. Relative error: below 5e-6; exact for whole y.
inline double coarse_exp2(double y) {
  y = y < -1000 ? -1000 : y > 1000 ? 1000 : y;
  const std::int64_t whole = static_cast<std::int64_t>(y + 1023) - 1023;  // rounds down
  const double u = y - static_cast<double>(whole);
  const double bend = (0.306996 + u * 0.065446) + (u * u) * 0.013702;
  const double power = (1 + u) + (u * (u - 1)) * bend;
  return power * bit_cast<double>(static_cast<std::uint64_t>(whole + 1023) << 52);
}

}  // namespace cromer::core
