// Limit cycles: negative damping feeds the swing, and another term bounds it.
#pragma once

#include <optional>

#include "cromer/model/oscillator.h"

namespace cromer::core {

/// The largest displacement [unit] of the limit cycle of an oscillator per unit mass without hysteresis:
/// the turning point from which the next one on the same side is as far out (H. Poincaré's map). Found by
/// secants from `near` > 0, an amplitude close to it; `period` > 0 [s] is roughly that of the swing. Error:
/// 1e-8 of it where the forces are smooth. Empty where none is found.
std::optional<double> limit_cycle_amplitude(const Oscillator<double>& per_mass, double near, double period);

}  // namespace cromer::core
