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

/// One curve. If a run did not settle (the method's own damping is negative), all but its frequency is NaN.
struct ResonanceCurve {
  std::string method;
  double damping_ratio = 0;
  std::vector<double> frequency{};        // [rad/s]
  std::vector<double> frequency_ratio{};  ///< over the undamped natural frequency
  std::vector<double> amplitude{};        // [m] relative to the base where that shakes
  std::vector<double> phase{};            // [rad] lag behind the force, 0 to pi apart from the method's error
  std::vector<double> amplification{};    ///< amplitude over F/k; base: over its own; unbalance: over m_u e/m
  std::vector<double> transmissibility{};  ///< force on the ground over force on the mass; base: displacement
                                           ///< of the mass over that of the base
  std::vector<double> transmitted_phase{};  // [rad] lag of what is transmitted
  std::vector<double> transmitted{};        // [N]; base: [m]
};

struct ResonanceResult {
  bool of_motion = false;              ///< a displacement is transmitted, else a force
  std::vector<ResonanceCurve> curves;  ///< damping ratio outermost, in the order of the methods
  std::vector<Notice> notices;
};

/// Each point is one run. It starts at the exact steady motion, lasts until the law's damping has brought the
/// method's own transient down to 1e-6 of the amplitude, and is measured over its last whole cycles; `exact`
/// is the closed form. An Error if nothing would settle: no damping, no drive, or a law that is not linear.
Result<ResonanceResult> resonance(const ResonanceOptions& options, const Watch& watch = {});

}  // namespace cromer::core
