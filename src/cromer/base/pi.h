// The circle's numbers.
#pragma once

#include <numbers>

namespace cromer::core {

inline constexpr double pi = std::numbers::pi;
inline constexpr double two_pi = 2 * pi;

}  // namespace cromer::core
