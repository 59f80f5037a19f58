// Motion under a sine, laid beside samples: compiled once, apart from the fit around it.
#pragma once

#include "cromer/identify/forced_motion.h"
#include "cromer/identify/motion/sinusoidal_force.h"

namespace cromer {

extern template NormalEquations forced_equations<SinusoidalForce>(ForcedTerms, const Parameters&,
                                                                  SinusoidalForce, const ForcedSamples&,
                                                                  double);

}  // namespace cromer
