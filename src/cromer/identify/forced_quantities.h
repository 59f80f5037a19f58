// What the parameters of a forced fit say about the apparatus, with the covariance carried over.
#pragma once

#include <string>
#include <vector>

#include "cromer/identify/forced_law.h"
#include "cromer/identify/least_squares/normal_equations.h"

namespace cromer {

/// Names in the contract's order, values, and the matrix of their derivatives by the parameters.
struct ForcedQuantities {
  std::vector<std::string> names;
  std::vector<double> values;
  std::vector<Parameters> derivatives;
};

/// Of a recorded force. `level` is what the parameters' z is measured from; with `zero_is_equilibrium` the
/// equilibrium is y = 0 and the force has an offset, else the reverse. Of a record of velocities or
/// accelerations the equilibrium is the sensor's offset, and neither the force's offset nor the place of rest
/// can be told.
ForcedQuantities recorded_quantities(const Parameters& parameters, ForcedTerms terms, double level,
                                     int derivative, bool zero_is_equilibrium);

/// Of a harmonic drive.
ForcedQuantities driven_quantities(const Parameters& parameters, ForcedTerms terms, double level,
                                   int derivative);

}  // namespace cromer
