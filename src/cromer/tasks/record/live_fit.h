// The law of a recording that is still going on.
#pragma once

#include <optional>
#include <string>

#include "cromer/base/interrupt.h"
#include "cromer/live/rows.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

constexpr std::size_t live_fit_rows = 100000;

/// Viscous law of the last live_fit_rows at most, found as `cromer fit --law viscous` finds it in the file.
/// `column` is a heading, with or without its unit; where none is named, the column that such a swing
/// explains best, by what is left of its spread. Nothing while the rows are too few to say anything, or
/// cannot be fitted at all.
std::optional<FittedRecording> live_fit(const Rows& rows, const Headings& headings, std::string_view column,
                                        const Watch& watch = {});

}  // namespace cromer::core
