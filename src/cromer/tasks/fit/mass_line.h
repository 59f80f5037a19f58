// The spring constant from the periods of several masses: T0^2 = (4 pi^2/k)(m + m_e).
//
// T0 is the undamped period, so that damping does not bend the line; m_e, what moves along with the mass (a
// third of the spring's), is its intercept over its slope.
#pragma once

#include <string>
#include <vector>

#include "cromer/analysis/line.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

struct MassLinePoint {
  std::string file;
  int run = 1;
  Quantity mass;           // [kg]
  Estimate period_square;  // [s²]
};

struct MassLine {
  std::vector<MassLinePoint> points;
  LineWithErrors line;      ///< period squared [s²] against mass [kg]
  Estimate stiffness;       // [N/m]
  Estimate effective_mass;  // [kg] m_e
  Estimate spring_mass;     // [kg] 3 m_e
  std::vector<Notice> notices;
};

/// One mass for each fit, in their order; fits that did not succeed are left out and said. Not as many masses
/// as fits, and fewer than two different masses left, are Errors.
Result<MassLine> mass_line(const std::vector<FittedRecording>& fits, const std::vector<Quantity>& masses);

}  // namespace cromer::core
