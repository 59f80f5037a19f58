// The laws without a closed form.
#pragma once

#include <optional>

#include "cromer/base/interrupt.h"
#include "cromer/identify/start/envelope_track.h"
#include "cromer/identify/free_decay.h"

namespace cromer {

/// What is found once and serves the fits of all laws.
struct Beginning {
  FreeDecay viscous;
  KnownMotion linear;                  ///< of the viscous law, as far as it goes
  std::optional<EnvelopeTrack> track;  ///< where the swing can be followed

  bool usable() const;                                 ///< the record is an oscillation
  KnownMotion known(const Law& law, double t0) const;  ///< where the iteration for a law begins
};
Beginning begin_fit(const Record& record, const FreeDecayOptions& options, const Watch& watch);

/// Fits options.law from a known motion. Only `roughly`: to a hundredth of the standard errors, in steps of a
/// twentieth of a period, for comparing laws.
FreeDecay fit_motion(const Record& record, const FreeDecayOptions& options, const KnownMotion& known,
                     const Watch& watch, bool roughly = false);

}  // namespace cromer
