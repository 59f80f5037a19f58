// A recording as one clean table, whatever dialect it came in.
#pragma once

#include "cromer/base/table.h"
#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core {

/// Run by run: the time first, in seconds and strictly increasing (repeated and backward rows left out), then
/// the other columns in the file's own units, missing values NaN. Without a time column the times come from
/// `options.rate`; without either there is no time column. Reading the table back, written under
/// column_heading, gives it again.
Result<Table> clean_table(const Recording& recording, const ReadOptions& options);

/// "Position (mm)", and "Position (mm) Run #2" in a table of several runs.
std::string column_heading(const Table& table, std::size_t column);

}  // namespace cromer::core
