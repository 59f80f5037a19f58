// Task: the law of a motion that something drove: a force recorded beside it, or a harmonic drive.
#pragma once

#include <string_view>

#include "cromer/study/task/fit.h"

namespace cromer {

/// That each option of a forced or driven fit stands where it has a meaning and has one of its values.
Result<void> check_forced_options(const FitOptions& options);

/// Whether a fit of something driven is asked for.
bool is_driven(const FitOptions& options);

/// One run's motion and the force column of the same run. Bad input (a force with gaps, at other times or
/// that never changes, times that are not even, a column that is no displacement) is an Error.
Result<FittedRecording> fit_forced(const Series& motion, const Series& force, std::string_view file,
                                   const FitOptions& options, const Watch& watch = {});

/// One run's motion under a harmonic drive of known or (--drive-frequency auto) unknown frequency.
Result<FittedRecording> fit_driven(const Series& motion, std::string_view file, const FitOptions& options,
                                   const Watch& watch = {});

/// The same motion fitted as a driven one, where that is what it is: a free law has left structure, and a
/// steady oscillation that makes up much of the motion accounts for it. Nothing otherwise, and where the law
/// or the drive was given.
std::optional<FittedRecording> recognise_drive(const FittedRecording& free, const Series& motion,
                                               const FitOptions& options, const Watch& watch = {});

}  // namespace cromer
