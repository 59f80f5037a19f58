// The unit that suits a length.
#pragma once

#include <string_view>

namespace cromer::core {

struct LengthUnit {
  std::string_view symbol;
  double metres;
};

/// The largest of m, cm and mm in which `size` [m] is at least 1; µm for anything smaller.
constexpr LengthUnit length_unit(double size) {
  constexpr LengthUnit units[] = {{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}};
  for (const auto& unit : units)
    if (size >= unit.metres) return unit;
  return {"µm", 1e-6};
}

}  // namespace cromer::core
