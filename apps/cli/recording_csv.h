// A recording of any dialect as plain CSV.
#pragma once

#include <string>

#include "cromer/base/table.h"
#include "cromer/study/task/inspect.h"

namespace cromer::cli {

/// "Position (mm)", with " Run #2" where runs stand side by side.
std::string column_header(const Column& column, bool with_run);

/// All columns, in the file's own units; a time column is added where the times come from `rate` [1/s].
std::string recording_csv(const Inspection& inspection, double rate);

}  // namespace cromer::cli
