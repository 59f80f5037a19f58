// Which terms a law of free motion has.
#pragma once

#include <string>
#include <string_view>

#include "cromer/base/result.h"

namespace cromer {

/// Which damping and stiffness terms are in the law. Viscous alone has a closed form.
struct Law {
  bool viscous = true;
  bool drag = false;
  bool friction = false;
  bool cubic = false;
  bool pendulum = false;  ///< sin x in place of x, x an angle [rad]

  friend bool operator==(const Law&, const Law&) = default;
};

/// Reads "viscous+drag": any sum of viscous, drag, friction, cubic and pendulum in any order, each at most
/// once, blanks allowed. An unknown term is an Error that suggests the nearest.
Result<Law> parse_law(std::string_view text);

/// Writes the terms in the order viscous, drag, friction, cubic, pendulum.
std::string to_text(const Law& law);

}  // namespace cromer
