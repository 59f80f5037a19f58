// Task: the law of a driven motion, and whether a motion is driven, free, or two modes at once.
#pragma once

#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "cromer/identify/choose/choose_law.h"
#include "cromer/identify/law_fit.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// Fits a motion under a harmonic drive. Its frequency is known, or searched for (--drive-frequency auto).
/// Whether there is a drive at all is for check_drive to say. `rms_to_beat` and `start` as in LawFitOptions.
Result<FittedRecording> fit_driven(const Series& motion, std::string_view file, const FitOptions& options,
                                   const Watch& watch = {}, double rms_to_beat = HUGE_VAL,
                                   const std::optional<KnownMotion>& start = {});

/// The damped natural frequency of a driven body [rad/s]. Empty unless its law is linear and it swings and
/// dies down by itself.
std::optional<double> damped_frequency_of(const LawFit& driven);

/// Fills in what every fit of a driven motion has. `t` are the times of its series, `force_unit` that of a
/// recorded force.
void describe_driven_fit(FittedRecording& result, LawChoice&& choice, const Record& record,
                         const std::vector<double>& t, std::string_view force_unit, const Watch& watch);

/// Names the options that a driven motion does not use.
void add_unused_notices(FittedRecording& result);

/// The fit of a motion that a drive surely makes: its own swing, as it dies down, beats with the drive's. No
/// free law of one swing does so, and none but the viscous one is tried. Empty where nothing beats, or a law
/// or a drive was given.
std::optional<FittedRecording> fit_beats(const Series& motion, std::string_view file,
                                         const FitOptions& options, const Watch& watch = {});

/// Returns the free fit, or the same motion fitted as a driven one if it is one: the free law leaves
/// structure in its residuals, and a steady oscillation that makes up much of the motion explains it better
/// than two decaying ones. Two modes stay with the free fit, which then names them, even if their beats were
/// refused as no oscillation. If a law or a drive was given, the free fit is returned as it is.
FittedRecording recognise_drive(FittedRecording free, const Series& motion, const FitOptions& options,
                                const Watch& watch = {});

/// Compares a fit under --drive-frequency with a free fit of the same samples. If nothing drives the motion,
/// the free fit is returned with a notice; if a frequency was given and the free law does not fit either, the
/// status is no_oscillation. If the drive is one of two steady lines, the record has two readings, and the
/// status is undetermined.
Result<FittedRecording> check_drive(FittedRecording driven, const Series& motion, const FitOptions& options,
                                    const Watch& watch = {});

}  // namespace cromer::core
