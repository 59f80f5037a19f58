// Amplitude and phase of a swing, followed through a record whatever its law, and the start values that they
// give: each term makes the amplitude fall and the frequency rise as cycle_average() says, in proportion to
// its coefficient. A pendulum's phase and action are exact at every amplitude.
#pragma once

#include <optional>
#include <vector>

#include "cromer/identify/motion/motion_model.h"

namespace cromer::core {

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

/// The motion of a law that follows the track best, from the record's first time t0 [s]. No coefficient that
/// cannot be negative is negative.
Motion motion_along(const EnvelopeTrack& track, const Law& law, double t0);

}  // namespace cromer::core
