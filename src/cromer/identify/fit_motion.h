// Fits of laws without a closed form: from a known motion to the minimum and its description.
#pragma once

#include <optional>

#include "cromer/base/interrupt.h"
#include "cromer/identify/law_fit.h"
#include "cromer/identify/start/envelope_track.h"

namespace cromer::core {

/// What is found once and serves the fits of all laws under one drive.
struct Beginning {
  LawFit linear;                       ///< fit of the viscous law; of a free motion by its closed form
  KnownMotion known_motion;            ///< the motion of `linear`, as far as it follows the record
  std::optional<EnvelopeTrack> track;  ///< of a free motion, where the swing can be followed

  bool usable() const { return linear.is_usable(); }  ///< the record is an oscillation
  /// Where the iteration for a law begins.
  KnownMotion known(const Law& law, const Record& record) const;
};
/// Fits the linear law to a record that refuse_record lets pass; of a free motion it also follows the swing.
/// Under a recorded force the law has a quadratic and a cubic spring as well, where options.law has them, and
/// a cubic one where another term bends the spring. Not usable() where no oscillation is found: `linear` then
/// says why.
Beginning begin_fit(const Record& record, const LawFitOptions& options, const Watch& watch);

/// Where laws are compared, steps may move a parameter by this share of its standard error, which changes the
/// Bayesian criterion by about four: where there is hardly any noise, the error of coarse steps hides which
/// law is right.
inline constexpr double comparing_share = 2;
/// What is left of a record counts as this share of the motion (rms) at least: no record is better.
inline constexpr double least_residual = 1e-6;

/// Fits options.law from a known motion. If `roughly`, only to a hundredth of the standard errors and in
/// coarse steps, for comparing laws.
LawFit fit_motion(const Record& record, const LawFitOptions& options, const KnownMotion& known,
                  const Watch& watch, bool roughly = false);

}  // namespace cromer::core
