// Task: the resonance curve of a damped oscillator, exact and as each method simulates it.
#pragma once

#include <string>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/base/result.h"
#include "cromer/study/task/simulate.h"

namespace cromer {

/// The law, its drive's amplitude, the methods and the step are those of `simulate`; its drive frequency and
/// end are set here.
struct ResonanceOptions {
  SimulateOptions simulate;
  double frequency_from = 0.1;  // [rad/s] > 0
  double frequency_to = 10;     // [rad/s] > frequency_from
  long long points = 200;       ///< >= 2, evenly spaced, both ends included
};

/// One curve. Where a run did not settle (the method's own damping is negative) amplitude and phase are NaN.
struct ResonanceCurve {
  std::string method;
  std::vector<double> frequency;  // [rad/s]
  std::vector<double> amplitude;  // [m]
  std::vector<double> phase;      // [rad] lag behind the force, 0 to pi but for the method's own error
};

struct ResonanceResult {
  std::vector<ResonanceCurve> curves;  ///< in the order of the methods
  std::vector<std::string> warnings;
};

/// Each point is a run from the exact steady motion, long enough for the method's own transient to fall to
/// 1e-6 of the amplitude by the law's damping, measured on its last whole cycles; `exact` is the closed form.
/// An Error where nothing would settle: no damping, no drive, or a law that is not linear.
Result<ResonanceResult> resonance(const ResonanceOptions& options, const Watch& watch = {});

}  // namespace cromer
