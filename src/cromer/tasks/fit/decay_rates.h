// The decay rate along a record, each part fitted by itself: in segments of equal length, and on stretches
// against the amplitude, beside what the law says there.
#pragma once

#include <optional>
#include <vector>

#include "cromer/analysis/swing.h"
#include "cromer/identify/law_fit.h"

namespace cromer::core {

struct DecaySegment {
  double from, to;  // [s]
  Estimate rate;    // [1/s]
};

struct DecaySegments {
  std::vector<DecaySegment> segments;
  std::optional<Estimate> mean;  ///< of the rates; its error from theirs
  std::vector<Notice> notices;   ///< of segments that are left out
};

/// Fits the viscous law, with an equilibrium of its own, to each whole segment from the first sample on: of
/// `length` [s] > 0, or the record in `count` > 0 equal parts, or with both at most `count` segments of that
/// length. None where neither is given, and a notice where a segment would hold less than 1.5 periods or 8
/// samples. What fails is left out, and said in one notice.
DecaySegments fit_segments(const Record& record, double period, std::optional<double> length,
                           std::optional<int> count, const Watch& watch = {});

struct AmplitudeRate {
  double from, to;   // [s] the stretch
  double amplitude;  ///< in its middle, unit of the displacement
  Estimate rate;     // [1/s] of one decaying sinusoid fitted to the stretch alone
  double law_rate;   // [1/s] the law's at that amplitude, averaged over a cycle
};

/// What the law's damping does to the amplitude.
AmplitudeDecay amplitude_decay(const LawFit& fit);

/// What its springs do to a swing.
Swing<double> swing_of(const LawFit& fit);

/// The largest swing that the law has from the first sample on: [unit of the displacement]; NaN of a
/// hysteretic law, whose force the state does not tell.
double first_amplitude(const LawFit& fit);

/// Stretches of at least two periods and twelve samples, as long as a rate takes to be known to a twentieth
/// and no longer than a sixth of the record; at most 60 of them. A stretch whose rate is less certain than
/// its size is left out; none where first_amplitude is NaN. `fit` has values. Errors are widened for the
/// correlation of the stretch's own residuals.
std::vector<AmplitudeRate> decay_by_amplitude(const Record& record, const LawFit& fit,
                                              const Watch& watch = {});

}  // namespace cromer::core
