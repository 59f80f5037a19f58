// How far a simulation is off at the end of a recording.
#pragma once

#include <span>

namespace cromer {

struct EndComparison {
  double amplitude_ratio = 1;  ///< simulated over measured
  double phase_drift = 0;      // [rad] simulated minus measured; whole turns count
};

/// Of two oscillations about 0 near the angular frequency `w` > 0 [rad/s], at the same times [s], strictly
/// increasing. Windows of ten periods follow the phase through the record, so that a drift beyond half a turn
/// is not folded back; the last, carried on to its end, gives the result.
EndComparison compare_ends(std::span<const double> t, std::span<const double> measured,
                           std::span<const double> simulated, double w);

}  // namespace cromer
