// Times in seconds for the rows of a table, and their repair.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core::dialects {

/// The time column that belongs to column `j`: the nearest before it in its run, else the first of its run,
/// else the first of all.
std::optional<std::size_t> time_column_of(const Table& table, std::size_t j);

/// The same for all columns.
std::vector<std::optional<std::size_t>> time_columns_of(const Table& table);

/// Rows where the times start again from near their beginning and go on from there. Missing times are passed
/// over.
std::vector<std::size_t> restarts(const std::vector<double>& t);

/// Which rows stay so that their times rise strictly, and what was left out.
struct RisingTimes {
  std::vector<std::size_t> kept;  ///< indices into the times given
  std::vector<Notice> notices;    ///< counts and first line numbers
};

/// Repeated and backward times are left out; where the time starts again, all from there on. A time that runs
/// backward throughout is an Error. `lines` are the file's line numbers of the times.
Result<RisingTimes> keep_rising(const std::vector<double>& t, const std::vector<long>& lines);

}  // namespace cromer::core::dialects
