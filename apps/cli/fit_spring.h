// The spring constant from several masses: by held extensions, or by their periods.
#pragma once

#include <string>
#include <vector>

#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/fit/spring_constant.h"
#include "output.h"

namespace cromer::core::cli {

/// What `cromer fit` is asked instead of, or beyond, the law.
struct SpringOptions {
  bool held = false;       ///< --static
  bool mass_line = false;  ///< --mass-line
  std::string masses;
  std::optional<Quantity> gravity;  // [m/s²]
};

std::vector<Option> options_of(SpringOptions& options);

/// That the options go together, and the masses can be read.
Result<void> check(const SpringOptions& options);

/// `cromer fit --static`, from the files to the exit status.
int run_static(const std::vector<std::string>& files, const FitOptions& fit, const SpringOptions& options,
               const OutputOptions& output);

}  // namespace cromer::core::cli
