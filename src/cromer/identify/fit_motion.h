// The laws without a closed form: from a known beginning to the minimum, and what it says.
#pragma once

#include <optional>

#include "cromer/base/interrupt.h"
#include "cromer/identify/law_fit.h"
#include "cromer/identify/start/envelope_track.h"

namespace cromer::core {

/// What is found once and serves the fits of all laws under one drive.
struct Beginning {
  LawFit linear;                       ///< the viscous law's: of a free motion by its closed form
  KnownMotion known_motion;            ///< of it, as far as it goes
  std::optional<EnvelopeTrack> track;  ///< of a free motion, where the swing can be followed

  bool usable() const { return linear.is_usable(); }  ///< the record is an oscillation
  /// Where the iteration for a law begins.
  KnownMotion known(const Law& law, const Record& record) const;
};
/// Fits the linear law to a record that refuse_record lets pass; of a free motion it also follows the swing.
/// Under a recorded force the law has a quadratic and a cubic spring as well, where options.law has them, and
/// a cubic one where another term bends the spring. Not usable() where no oscillation is found: `linear` then
/// says why. After an interruption it may be usable and lack the rest.
Beginning begin_fit(const Record& record, const LawFitOptions& options, const Watch& watch);

/// Fits options.law from a known motion. Only `roughly`: to a hundredth of the standard errors, in coarse
/// steps, for comparing laws.
LawFit fit_motion(const Record& record, const LawFitOptions& options, const KnownMotion& known,
                  const Watch& watch, bool roughly = false);

}  // namespace cromer::core
