// Task: the law of a motion that something drove: a force recorded beside it, or a harmonic drive.
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

}  // namespace cromer::core
