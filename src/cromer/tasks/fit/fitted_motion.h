// Velocity and energy of a recorded motion, and their units, without the bias of finite differences.
//
// A difference of neighbouring samples multiplies their noise and shrinks an oscillation. The fitted law's
// own velocity does neither. Beside it stands a check that uses the samples alone: in a window of about a
// period around each, a sinusoid and a level are fitted, whose slope in the middle is the velocity.
#pragma once

#include <string>
#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// One value for each sample used, in SI units.
struct FittedMotion {
  std::vector<double> t;               // [s]
  std::vector<double> measured;        ///< the column
  std::vector<double> residual;        ///< measured less fitted
  std::vector<double> x, v;            ///< displacement from the equilibrium and velocity of the law
  std::vector<double> local_velocity;  ///< from those not set aside; NaN where a window has less than 8
  std::vector<double> energy;          ///< of the law, with its mass [J], else per unit mass
  bool per_mass = true;
};

/// `fitted` has values, of a position, an angle or one of their derivatives: x and v are those of the
/// displacement whatever was recorded; local_velocity is empty unless it was a displacement. An angle's
/// energy is per moment of inertia.
FittedMotion fitted_motion(const FittedRecording& fitted);

/// Energy of states of the fitted law's oscillator, x from its equilibrium [m] and v [m/s], kinetic and of
/// its spring: with its mass [J], else per unit mass (of an angle: of inertia).
std::vector<double> energies_of(const FittedRecording& fitted, const std::vector<double>& x,
                                const std::vector<double>& v);

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
