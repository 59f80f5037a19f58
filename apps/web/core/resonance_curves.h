// Where the motion settles under a harmonic drive, against its frequency, as each method simulates it.
#pragma once

#include <string>
#include <vector>

#include "cromer/base/grid.h"
#include "cromer/result.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core::page {

/// One method's resonance curve.
struct MethodResonance {
  std::string method;
  bool settled = true;              ///< false: its motion grows, or never settles, or was not tried
  bool too_many_steps = false;      ///< why it was not tried
  std::vector<double> frequency{};  // [rad/s]
  std::vector<double> amplitude{};  // [m]
  std::vector<double> phase{};      // [rad] lag behind the force
};

/// One for each method of the options. Of a linear law and a method with a step of its own by the closed form
/// of the method's map; else by stepping (settled_curve.h). An Error where nothing drives it.
Result<std::vector<MethodResonance>> resonance_curves(const SimulateOptions& options,
                                                      const Grid& frequencies);

}  // namespace cromer::core::page
