#include "cromer/identify/motion/integrate_through.h"

namespace cromer::core {

const MotionFunctions recorded_motions = MotionUnit<driven_laws, RecordedColumns>::functions();

}  // namespace cromer::core
