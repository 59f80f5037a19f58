#include "cromer/identify/driven_motion.h"

namespace cromer {

template NormalEquations forced_equations<SinusoidalForce>(ForcedTerms, const Parameters&, SinusoidalForce,
                                                           const ForcedSamples&, double);

}  // namespace cromer
