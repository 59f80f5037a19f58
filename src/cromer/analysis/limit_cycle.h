// The swing that keeps itself: negative damping feeds it, and another term bounds it.
#pragma once

#include <optional>

#include "cromer/model/oscillator.h"

namespace cromer::core {

/// The largest displacement [unit] of the limit cycle of an oscillator per unit mass without hysteresis, from
/// `near` > 0, an amplitude not far from it, and `period` > 0 [s], about that of the swing: where the next
/// turning point on the same side is as far out (H. Poincaré's map), by secants. Error: 1e-8 of it where the
/// forces are smooth. Empty where none is found.
std::optional<double> limit_cycle_amplitude(const Oscillator<double>& per_mass, double near, double period);

}  // namespace cromer::core
