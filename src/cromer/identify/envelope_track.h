// Amplitude and phase of a swing, followed through a record whatever its law, and the start values that they
// give: the amplitude falls as
//
//   dA/dt = -(s + b A + q A²),   s = 2 f/(pi w),  b the decay rate,  q = 4 (drag) w/(3 pi)
//
// and the phase runs as w0 + 3 k3 A²/(8 w0). Averages over a cycle: N. N. Bogoliubov & Y. A. Mitropolsky,
// Asymptotic Methods (1961), chapter 1. A pendulum's phase and action are exact at every amplitude.
#pragma once

#include <optional>
#include <vector>

#include "cromer/identify/free_motion.h"

namespace cromer {

struct EnvelopeTrack {
  std::vector<double> t;          // [s] middles of windows of some periods each
  std::vector<double> amplitude;  ///< of the displacement
  std::vector<double> phase;      // [rad] of the displacement A cos(phase), unwrapped
  double frequency = 0;           // [rad/s] at the first window
  double equilibrium = 0;         ///< in the unit of the record
  std::size_t samples = 0;        ///< up to where the phase is known, all where the swing dies away
  std::size_t swinging = 0;       ///< up to where there is a swing
};

/// Follows a swing whose frequency begins near `angular_frequency` > 0 [rad/s] and which fades about as
/// `decay_rate` >= 0 [1/s] says. Empty where fewer than three windows show it.
std::optional<EnvelopeTrack> track_envelope(const Record& record, double angular_frequency,
                                            double decay_rate);

/// The motion of a law that follows the track best, from the record's first time t0. None of decay rate, drag
/// and friction is negative.
MotionParameters motion_along(const EnvelopeTrack& track, const Law& law, double t0);

}  // namespace cromer
