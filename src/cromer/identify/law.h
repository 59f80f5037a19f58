// A law of motion by the names of its terms, as a person types it.
#pragma once

#include <string>
#include <string_view>

#include "cromer/model/law.h"
#include "cromer/result.h"

namespace cromer::core {

/// Reads "viscous+drag": any sum of the registry's terms in any order, each at most once, blanks allowed. A
/// linear spring is part of it, or a pendulum in its place. An unknown term is an Error that suggests the
/// nearest.
Result<Law> parse_law(std::string_view text);

/// Writes the terms in the order of the registry; the spring goes without saying.
std::string to_text(const Law& law);

/// The names of all terms that can be typed, "viscous, drag, … and pendulum".
std::string law_names();

}  // namespace cromer::core
