// The decay rate along a record, each part fitted by itself: in segments of equal length, and on stretches
// against the amplitude, beside what the law says there.
#pragma once

#include <optional>
#include <vector>

#include "cromer/analysis/swing.h"
#include "cromer/identify/diagnose/second_mode.h"
#include "cromer/identify/law_fit.h"

namespace cromer::core {

struct DecaySegment {
  double from, to;  // [s]
  Estimate rate;    // [1/s]
};

struct DecaySegments {
  std::vector<DecaySegment> segments;
  std::optional<Estimate> mean;  ///< of the rates; its error from theirs
  std::vector<Notice> notices;   ///< on what is left out
};

/// Fits the viscous law, with an equilibrium of its own, to one segment after the other from the first sample
/// on. `length` [s] > 0 is their length; `count` > 0 alone divides the record into equal parts; both together
/// give at most `count` segments of that length; with neither there are none. Segments that would hold less
/// than 1.5 periods or 8 samples are not fitted, and a notice says so. A segment whose fit fails is left out;
/// one notice tells of all of them.
DecaySegments fit_segments(const Record& record, double period, std::optional<double> length,
                           std::optional<int> count, const Watch& watch = {});

struct AmplitudeRate {
  double from, to;               // [s] the stretch
  double amplitude;              ///< in its middle, unit of the displacement
  Estimate rate;                 // [1/s] by a fit to the stretch alone, beside the law's course
  Estimate angular_frequency;    // [rad/s] of that sinusoid
  double law_rate;               // [1/s] the law's at that amplitude, averaged over a cycle
  double law_angular_frequency;  // [rad/s] the law's there
  double widened = 1;            ///< the rate's error was multiplied by this: see decay_by_amplitude()
};

/// What the law's damping does to the amplitude.
AmplitudeDecay amplitude_decay(const LawFit& fit);

/// Angular frequency [rad/s] by the law of the swings between which the amplitude is `amplitude` > 0 [unit of
/// the displacement], of viscous damping at the law's rate there.
double law_angular_frequency(const LawFit& fit, double amplitude);

/// Rates that differ by less, relative, are one for whoever reads them.
inline constexpr double alike_rates = 0.02;

/// The parameter of this name; null where there is none.
const Parameter* named(const std::vector<Parameter>& list, std::string_view name);

/// Whether the 95 % intervals have nothing in common.
bool are_apart(const Estimate& one, const Estimate& other);

/// Whether the decay rates at both ends of a record are the same, by the law.
bool is_one_rate(const Estimate& start, const Estimate& end);

/// The law's springs alone, without what damps or drives.
Swing<double> swing_of(const LawFit& fit);

/// Amplitude of the swing that begins at the first sample [unit of the displacement]. NaN for a hysteretic
/// law: its force does not follow from the state.
double first_amplitude(const LawFit& fit);

/// The decay rate and the frequency of stretches of the record against their amplitude, each beside
/// what the law makes of the swing's phase and amplitude within the stretch. A stretch holds at least two
/// periods and twelve samples; beside something else that swings, one of these `lines`, three beats. It is as
/// long as its rate takes to be known to 5 %, but at most a sixth of the record, or the time in which the
/// swing halves; there are at most 60. A stretch whose error exceeds both its rate and the law's is left out.
/// Empty if first_amplitude is NaN. `fit` must have values. Errors, of rate and frequency, are widened for
/// the correlation of the stretch's own residuals and for the lines, and, of eight stretches or more,
/// multiplied by the rms of the second differences of what is measured less the law's, in units of their
/// errors and without the largest, where that exceeds 1 by more than chance: noise that is slower than a
/// stretch does not show within it.
std::vector<AmplitudeRate> decay_by_amplitude(const Record& record, const LawFit& fit,
                                              const std::vector<ResidualLine>& lines = {},
                                              const Watch& watch = {});

/// Whether the first and the last stretch, each by itself, show that the rate falls (sign 1) or rises (-1).
bool stretches_differ(const std::vector<AmplitudeRate>& stretches, double sign);

struct ExtremeRates {
  const AmplitudeRate &lowest, &highest;
};
/// The stretches of the lowest and of the highest rate, of `stretches`, of which there is one at least.
ExtremeRates extreme_rates(const std::vector<AmplitudeRate>& stretches);

/// Whether the largest amplitude is more than ten times the smallest: a linear axis would crowd most
/// stretches at its lower end.
bool span_a_decade(const std::vector<AmplitudeRate>& stretches);

}  // namespace cromer::core
