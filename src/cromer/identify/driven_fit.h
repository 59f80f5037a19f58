// From the record of a harmonically driven motion, its beginning included, to its law and its drive.
//
//   x'' = A cos(w s + phase) - w0^2 x - 2 g x' - q x'|x'| - k2 x^2 - k3 x^3,   s from the first sample
#pragma once

#include <optional>

#include "cromer/identify/forced_choice.h"

namespace cromer {

/// One law. `drive` [rad/s] is where the drive's frequency is looked for; the spectrum tells it if it is not
/// given. It is fitted in either case: a frequency read off a generator is seldom as exact as a record of
/// many periods. `start` gives all parameters to begin with.
ForcedFit fit_driven(const Record& record, ForcedTerms terms, std::optional<double> drive,
                     const std::optional<Parameters>& start = {}, const Watch& watch = {});

/// The law asked for, or the one the record asks for (as choose_forced).
ForcedChoice choose_driven(const Record& record, const std::optional<ForcedTerms>& terms,
                           std::optional<double> drive, const Watch& watch = {});

}  // namespace cromer
