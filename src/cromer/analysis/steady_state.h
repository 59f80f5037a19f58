// The steady motion measured from a simulated trajectory.
#pragma once

#include "cromer/analysis/frequency_response.h"
#include "cromer/model/oscillator.h"
#include "cromer/result.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// What the end of a driven motion looks like at the drive's frequency.
struct MeasuredSteadyState {
  double amplitude = 0;  // [m]
  double phase_lag = 0;  // [rad] behind the drive, -pi/2 to 3 pi/2
  double mean = 0;       // [m]
  double residual = 0;   // [m] rms of what is not mean or drive frequency: overtones and transients
  double change = 0;  ///< of the amplitude from the first to the second half of the window, relative: 0 once
                      ///< transients have died
  double growth = 0;  ///< likewise of the residual, over the amplitude: above 0 a free motion grows
  int cycles = 0;     ///< in the window

  /// The amplitude no longer changes by more than one part in a thousand of it, and nothing else grows by
  /// more.
  bool settled() const { return change < 1e-3 && change > -1e-3 && growth < 1e-3; }
};

/// Least squares, with Hann's weights over the window, of x = mean + a cos(w t + phi) + b sin(w t + phi) over
/// the last `cycles` whole drive periods (even; fewer where the trajectory is shorter); a last state after a
/// shorter step is left out. An Error for a drive that is no oscillation, or if the trajectory has fewer than
/// two periods or less than four samples a period.
Result<MeasuredSteadyState> measure_steady_state(const Trajectory& trajectory,
                                                 const HarmonicDrive<double>& drive, int cycles = 10);

}  // namespace cromer::core
