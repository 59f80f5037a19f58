// What the options of a fit say, and whether they suit each other.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// Whether a driven fit is asked for.
bool is_driven(const FitOptions& options);

/// Whether --law names a law; otherwise the data choose it.
bool law_is_chosen(const FitOptions& options);

/// Names of the given options that only a free decay can answer: segment, segments, goal, textbook.
std::vector<std::string_view> unused_if_driven(const FitOptions& options);

/// How --between-samples reads the force; empty for auto.
std::optional<BetweenSamples> reading_of(const FitOptions& options);

/// The law of --law and --no-spring; empty for auto.
Result<std::optional<Law>> law_of(const FitOptions& options);

/// The angular frequency of --drive-frequency [rad/s]; empty for auto.
Result<std::optional<double>> drive_of(const FitOptions& options);

/// The Error of a file whose runs are not as many as the masses of this option.
Error unlike_runs(std::string_view option, std::string_view file, std::size_t masses, std::size_t runs);

}  // namespace cromer::core
