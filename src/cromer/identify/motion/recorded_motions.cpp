#include "cromer/identify/motion/integrate_through.h"

namespace cromer::core {

using Unit = MotionUnit<driven_laws, RecordedColumns>;

const MotionFunctions recorded_motions{Unit::states, Unit::observed, Unit::equations, Unit::jacobian};

}  // namespace cromer::core
