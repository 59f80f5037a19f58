// The law of motion, as the whole house writes it; its terms stand in terms/, one header each.
#pragma once

#include "cromer/oscillator.h"

namespace cromer::core {

template <class Real>
using Oscillator = OscillatorOf<Real>;

}  // namespace cromer::core
