// The steady motion under a harmonic drive against its frequency, as each method simulates it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cromer/base/grid.h"
#include "cromer/result.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core::page {

/// The resonance curve of one method.
struct MethodResonance {
  std::string method;
  bool settled = true;               ///< false if the motion grows, never settles or was not tried
  bool too_many_steps = false;       ///< the reason why it was not tried
  std::vector<double> frequency{};   // [rad/s]
  std::vector<double> amplitude{};   // [m]
  std::vector<double> phase{};       // [rad] lag behind the force
  std::optional<double> at_drive{};  // [m] steady amplitude at the drive's own frequency
};

/// One curve for each method of the options: by the closed form of the method's map if the law is linear and
/// the steps are fixed, else by stepping until the motion settles. An Error if nothing drives the motion.
Result<std::vector<MethodResonance>> resonance_curves(const SimulateOptions& options,
                                                      const Grid& frequencies);

}  // namespace cromer::core::page
