// Tables below each other in one file, each with a header of its own: DataStudio's runs, a sketch started
// again.
#pragma once

#include "cromer/read/recording.h"
#include "cromer/read/set.h"

namespace cromer::core::dialects {

/// Where tables begin (line indices, the first is 0): at a line of names above rows that is the first header
/// once more, or whose first name is a time; with the titles right above it. One where there is but one.
std::vector<std::size_t> find_tables(const std::vector<std::string_view>& lines);

/// Reads each table by the common stages. Tables whose titles name the same "Run #N" are one run.
Result<Recording> read_tables(const std::vector<std::string_view>& lines,
                              const std::vector<std::size_t>& starts, const ReadOptions& options);

/// A recording taken apart into sets again, one for each run.
std::vector<Set> as_sets(Recording recording, const std::string& label);

}  // namespace cromer::core::dialects
