// What a recorded force did between its samples, by what its motion says.
#pragma once

#include <functional>

#include "cromer/identify/choose/choose_law.h"

namespace cromer::core {

/// The law under each reading of options.drive.force that is not given: `choose` makes the choice under one.
/// The reading of lowest BIC is taken. Those within 6 of it stay open: they are named in a notice, and their
/// spread, weighted by what the criterion makes of them, goes into covariance, errors and intervals.
LawChoice choose_reading(const Record& record, const LawFitOptions& options, const GivenLaw& given,
                         const std::function<LawChoice(const LawFitOptions&)>& choose, const Watch& watch);

}  // namespace cromer::core
