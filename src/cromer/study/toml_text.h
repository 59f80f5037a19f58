// Texts and options as a study file writes them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/tasks/option/option.h"

namespace cromer::core {

/// A text in quotes, as TOML has it.
std::string toml_text(std::string_view text);

/// A text that stands for itself: in a study a brace begins a result, but for that of x_{1} and x^{2}.
std::string verbatim(std::string_view text);

/// A line for each option, once with all its values: mass = "217.6 g".
std::string toml_settings(const std::vector<TypedOption>& options);

}  // namespace cromer::core
