#include "cromer/identify/motion/integrate_through.h"

namespace cromer::core {

const MotionFunctions harmonic_motions = MotionUnit<driven_laws, HarmonicColumns>::functions();

}  // namespace cromer::core
