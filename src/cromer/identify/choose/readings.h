// What a recorded force did between its samples, chosen by the motion that it drove.
#pragma once

#include <functional>

#include "cromer/identify/choose/choose_law.h"

namespace cromer::core {

/// Chooses a law under each reading of options.drive.force, unless the reading is given; `choose` makes the
/// choice under one reading. The reading of lowest BIC is taken. Those within 6 of it stay open: a notice
/// names them, and their spread, weighted by the criterion, goes into covariance, errors and intervals.
LawChoice choose_reading(const Record& record, const LawFitOptions& options, const GivenLaw& given,
                         const std::function<LawChoice(const LawFitOptions&)>& choose, const Watch& watch);

}  // namespace cromer::core
