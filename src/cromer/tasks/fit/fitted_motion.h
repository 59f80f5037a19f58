// Velocity and energy of a recorded motion without the bias of finite differences, and their units.
//
// A difference of neighbouring samples multiplies their noise and shrinks an oscillation. The fitted law's
// own velocity does neither. The samples correct it: a sinusoid and a level are fitted to what the law leaves
// in a window of a period around each sample, and their slope in the middle is added.
#pragma once

#include <string>
#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// One value for each sample used, in SI units.
struct FittedMotion {
  std::vector<double> t;         // [s]
  std::vector<double> measured;  ///< the column
  std::vector<double> residual;  ///< measured less fitted
  std::vector<double> x, v;      ///< displacement from the equilibrium and velocity of the law
  std::vector<double>
      local_velocity;  ///< by the samples not set aside; NaN if a window is cut off or has less than 8
  std::vector<double> energy;  ///< of the law, with its mass [J], else per unit mass
  bool per_mass = true;
};

/// `fitted` must have values. Whatever was recorded (a position, an angle or a derivative of them), x and v
/// are those of the displacement. local_velocity is empty unless a displacement was recorded. The energy of
/// an angle is per moment of inertia.
FittedMotion fitted_motion(const FittedRecording& fitted);

/// Kinetic and spring energy of states of the fitted oscillator: x from its equilibrium [m], v [m/s]. In J if
/// the mass is known, else per unit mass (of an angle: per moment of inertia).
std::vector<double> energies_of(const FittedRecording& fitted, const std::vector<double>& x,
                                const std::vector<double>& v);

/// The same without energy and local_velocity, which take several times as long.
FittedMotion law_motion(const FittedRecording& fitted);

/// SI units of a recorded motion; "" if a unit is not known.
struct MotionUnits {
  std::string measured;      ///< of the column, and of the residuals
  std::string displacement;  ///< of x and of amplitudes
  std::string velocity;
  std::string energy;  ///< per unit mass without a mass; of an angle per moment of inertia
};

/// `fitted` need not have values. With a stiffness among its parameters the energy is in J.
MotionUnits motion_units(const FittedRecording& fitted);

}  // namespace cromer::core
