// How a simulated motion meets a measured one at the end of a record: its size and its phase there.
#pragma once

#include <cstddef>
#include <span>

namespace cromer::core {

/// Of two motions sampled at the same times.
struct EndComparison {
  double amplitude_ratio = 1;  ///< of the second over the first
  double phase_drift = 0;      // [rad] of the second minus the first, followed through the record
  double first_amplitude = 0, second_amplitude = 0;  ///< at the end
  std::size_t samples = 0;                           ///< that the amplitudes at the end rest on
};

/// Windows of ten periods 2 pi/w follow the phase through the record, so that a drift beyond half a turn is
/// not folded back; the last one, carried on from its middle to its end, gives the result. The frequency of
/// each window is that of `guide`, a motion without noise near both, where it turns there; else w [rad/s].
EndComparison compare_ends(std::span<const double> t, std::span<const double> first,
                           std::span<const double> second, std::span<const double> guide, double w);

}  // namespace cromer::core
