// One method's resonance curve.
#pragma once

#include <string>
#include <vector>

namespace cromer::core::page {

struct MethodResonance {
  std::string method;
  bool settled = true;              ///< false: its motion grows, or never settles, or was not tried
  bool too_many_steps = false;      ///< why it was not tried
  std::vector<double> frequency{};  // [rad/s]
  std::vector<double> amplitude{};  // [m]
  std::vector<double> phase{};      // [rad] lag behind the force
};

}  // namespace cromer::core::page
