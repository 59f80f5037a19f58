// Task: the law of a motion that something drove, a force recorded beside it or a harmonic drive; and whether
// a motion is driven, free, or two swings at once.
#pragma once

#include <string_view>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// One run's motion and the force column of the same run. Bad input (a force with gaps, at other times or
/// that never changes, times that are not even) is an Error.
Result<FittedRecording> fit_forced(const Series& motion, const Series& force, std::string_view file,
                                   const FitOptions& options, const Watch& watch = {});

/// One run's motion under a harmonic drive of known or (--drive-frequency auto) unknown frequency; whether
/// there is one, check_drive tells.
Result<FittedRecording> fit_driven(const Series& motion, std::string_view file, const FitOptions& options,
                                   const Watch& watch = {});

/// A free fit, or the same motion fitted as a driven one where that is what it is: a free law has left
/// structure, and a steady oscillation that makes up much of the motion accounts for it better than two
/// decaying ones. Two modes stay with the free fit, which then names them, also where their beats were
/// refused as no oscillation. As it is where law or drive was given.
FittedRecording recognise_drive(FittedRecording free, const Series& motion, const FitOptions& options,
                                const Watch& watch = {});

/// A fit under --drive-frequency, held against a free one of the same samples. Where nothing drives, auto
/// gives the free fit, and a frequency that was named a notice, or no_oscillation where the motion is driven
/// at another one. Two steady lines, of which the drive is one, are said to have two readings.
Result<FittedRecording> check_drive(FittedRecording driven, const Series& motion, const FitOptions& options,
                                    const Watch& watch = {});

}  // namespace cromer::core
