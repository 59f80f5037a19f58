// Where the motion settles under a harmonic drive, against its frequency, as each method simulates it.
#pragma once

#include <string>
#include <vector>

#include "cromer/base/grid.h"
#include "cromer/base/result.h"
#include "cromer/study/task/simulate.h"

namespace cromer::page {

struct MethodResonance {
  std::string method;
  bool settled = true;              ///< false: its motion grows, or never settles
  std::vector<double> frequency{};  // [rad/s]
  std::vector<double> amplitude{};  // [m]
  std::vector<double> phase{};      // [rad] lag behind the force
};

/// Of a linear law, by the closed form of each method's map at the step of the options. An Error where the
/// law is not linear, or nothing drives it.
Result<std::vector<MethodResonance>> resonance_curves(const SimulateOptions& options,
                                                      const Grid& frequencies);

}  // namespace cromer::page
