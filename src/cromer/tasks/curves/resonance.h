// Task: resonance curve and transmissibility of a damped oscillator, exact and as each method simulates them.
#pragma once

#include <string>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/result.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// The law, its drive (harmonic force, unbalance or base), the methods and the step are those of `simulate`;
/// its drive frequency and end are set here.
struct ResonanceOptions {
  SimulateOptions simulate;
  double frequency_from = 0.1;          // [rad/s] > 0
  double frequency_to = 10;             // [rad/s] > frequency_from
  long long points = 200;               ///< >= 2, evenly spaced, both ends included
  std::vector<double> damping_ratio{};  ///< > 0; one curve each, in place of the law's damping
};

/// One curve. Where a run did not settle (the method's own damping is negative) all but the frequency is NaN.
struct ResonanceCurve {
  std::string method;
  double damping_ratio = 0;
  std::vector<double> frequency{};        // [rad/s]
  std::vector<double> frequency_ratio{};  ///< over the undamped natural frequency
  std::vector<double> amplitude{};        // [m] relative to the base where that shakes
  std::vector<double> phase{};          // [rad] lag behind the force, 0 to pi but for the method's own error
  std::vector<double> amplification{};  ///< amplitude over F/k; over the base's; of an unbalance over m_u e/m
  std::vector<double> transmissibility{};  ///< force on the ground over the force; of a base its displacement
                                           ///< that reaches the mass
  std::vector<double> transmitted_phase{};  // [rad] lag of what arrives
  std::vector<double> transmitted{};        // [N]; of a base [m]
};

struct ResonanceResult {
  bool of_motion = false;              ///< what is transmitted is a displacement
  std::vector<ResonanceCurve> curves;  ///< damping ratio outermost, in the order of the methods
  std::vector<Notice> notices;
};

/// Each point is a run from the exact steady motion, long enough for the method's own transient to fall to
/// 1e-6 of the amplitude by the law's damping, measured on its last whole cycles; `exact` is the closed form.
/// An Error where nothing would settle: no damping, no drive, or a law that is not linear.
Result<ResonanceResult> resonance(const ResonanceOptions& options, const Watch& watch = {});

}  // namespace cromer::core
