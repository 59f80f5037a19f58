// The phase of a swing, followed from state to state.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "cromer/base/pi.h"

namespace cromer::core {

/// The angle of (x, -v/w), which grows with the time by about w: [rad], without jumps while a step is shorter
/// than half a turn. x and v have the same length; w > 0 [rad/s] is the swing's frequency. NaN from where it
/// stands still for good.
inline std::vector<double> followed_phase(const std::vector<double>& x, const std::vector<double>& v,
                                          double w) {
  std::vector<double> phase;
  phase.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    double angle = std::atan2(-v[i] / w, x[i]);
    if (i > 0) angle += two_pi * std::round((phase.back() - angle) / two_pi);
    phase.push_back(angle);
  }
  for (std::size_t i = x.size(); i-- > 1 && v[i] == 0 && x[i] == x[i - 1];)
    phase[i] = std::numeric_limits<double>::quiet_NaN();
  return phase;
}

}  // namespace cromer::core
