// The SI units of a recorded motion and of what its law says.
#pragma once

#include <string>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// "" where a unit has no name.
struct MotionUnits {
  std::string measured;      ///< of the column, and of what the law leaves of it
  std::string displacement;  ///< of x, and of the amplitudes
  std::string velocity;
  std::string energy;  ///< without a mass per mass, of an angle per moment of inertia
};

/// Of any recording, fitted or not; with a stiffness among the parameters the energy is in J.
MotionUnits motion_units(const FittedRecording& fitted);

}  // namespace cromer::core
