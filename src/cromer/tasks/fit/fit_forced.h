// Task: the law of a motion under a recorded force. The page leaves it out.
#pragma once

#include <string_view>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// Fits a motion under a force that was recorded in the same run. Bad input is an Error: a force with gaps,
/// one that never changes, one sampled unevenly or at other times.
Result<FittedRecording> fit_forced(const Series& motion, const Series& force, std::string_view file,
                                   const FitOptions& options, const Watch& watch = {});

/// The column of the force. An Error names --force-column.
Result<Series> take_force(const Recording& recording, const FitOptions& options, int run);

/// Whether what is wrong is a force's, and names neither file nor option, but a column or a line.
bool is_about_a_force(const Notice& what);

}  // namespace cromer::core
