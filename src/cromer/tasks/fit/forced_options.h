// What the options of a forced or driven fit say.
#pragma once

#include <optional>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// Whether a fit of something driven is asked for.
bool is_driven(const FitOptions& options);

/// Whether --law names one; else the data choose it.
bool law_is_chosen(const FitOptions& options);

/// The names of the options given that ask for something of a free decay: segment, segments, goal, textbook.
std::vector<std::string_view> unused_if_driven(const FitOptions& options);

/// That each option of a forced or driven fit stands where it has a meaning and has one of its values.
Result<void> check_forced_options(const FitOptions& options);

/// How --between-samples reads the force; nothing for auto.
std::optional<BetweenSamples> reading_of(const FitOptions& options);

/// The law of --law and --no-spring; nothing for auto.
Result<std::optional<Law>> law_of(const FitOptions& options);

/// The [rad/s] of --drive-frequency; nothing for auto.
Result<std::optional<double>> drive_of(const FitOptions& options);

}  // namespace cromer::core
