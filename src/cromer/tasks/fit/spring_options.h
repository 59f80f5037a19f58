// The options of a spring constant from several masses.
#pragma once

#include <optional>
#include <vector>

#include "cromer/base/quantity.h"
#include "cromer/result.h"
#include "cromer/tasks/fit/spring_constant.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {

/// What a fit is asked instead of, or beyond, the law.
struct SpringOptions {
  bool held = false;                  ///< --static
  bool mass_line = false;             ///< --mass-line
  std::vector<Quantity> masses{};     // [kg] >= 0
  std::optional<Quantity> gravity{};  // [m/s²] > 0

  bool any() const { return held || mass_line; }
};

std::vector<Option> options_of(SpringOptions& options);

/// What a fit of held masses is asked, by its options and those of fit.
StaticOptions static_options(const FitOptions& fit, const SpringOptions& spring);

/// Checks that the options go together, and that there are masses where they are needed. `only_held`: there
/// is no --mass-line.
Result<void> check_spring_options(const SpringOptions& options, bool only_held = false);

}  // namespace cromer::core
