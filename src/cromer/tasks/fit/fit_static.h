// Task: from held extensions to the spring constant.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cromer/tasks/fit/static_stiffness.h"

namespace cromer::core {

struct StaticOptions {
  FitOptions fit{};              ///< reading, column, run, from and to are used
  std::string masses{};          ///< "48.4 g, 67.95 g, 87.96 g", one for each hold
  Quantity gravity{9.80665, 0};  // [m/s²] > 0
};

/// A file's name and its bytes.
using NamedBytes = std::pair<std::string, std::string>;

/// The holds in the order of the files and their runs; a file of one run may hold several plateaus where it
/// is the only file. Files without times need no rate. Bad input is an Error.
Result<StaticStiffness> fit_static(const std::vector<NamedBytes>& files, const StaticOptions& options);

}  // namespace cromer::core
