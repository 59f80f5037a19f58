// What is in a file as a text for people.
#pragma once

#include <string>

#include "cromer/tasks/inspect/inspect.h"

namespace cromer::core {

/// Dialect, columns, rate, gaps and outliers, a line each; of long lists the first twenty.
std::string inspect_text(const Inspection& inspection);

}  // namespace cromer::core
