// The units that motions are compiled in, one for each kind of drive.
#pragma once

#include "cromer/identify/motion/motion_model.h"

namespace cromer::core {

/// What a unit does; see motion_model.h.
struct MotionFunctions {
  Trajectory (*states)(const Motion&, const Drive&, std::span<const double>, double);
  std::vector<double> (*observed)(const Motion&, const Drive&, std::span<const double>, int, double);
  NormalEquations (*equations)(const FittedParameters&, const Parameters&, const Drive&, const Record&,
                               double);
  std::vector<double> (*jacobian)(const FittedParameters&, const Parameters&, const Drive&, const Record&,
                                  double);
};

extern const MotionFunctions free_motions, harmonic_motions, recorded_motions;

}  // namespace cromer::core
