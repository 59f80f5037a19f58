// Stage 7: what each column is: its name, its run, whether it is the time.
#pragma once

#include <string>
#include <vector>

#include "cromer/base/table.h"
#include "cromer/read/header.h"
#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core {

/// "Position (mm)": name and unit as headings write them.
std::string column_title(const Column& column);

/// The titles of the columns with these indices, each in quotes.
std::vector<std::string> quoted_titles(const std::vector<Column>& columns,
                                       const std::vector<std::size_t>& chosen);

/// The number of rows of a run, empty ones at its end not counted.
std::size_t rows_of_run(const Table& table, int run);

/// Finds a column by its name among those of `run` (0: of all runs): an exact match, else one without case,
/// decoration and unit, else one without a subscript. No match, or several, is an Error that lists the
/// columns (without the file's name).
Result<std::size_t> find_column(const Table& table, std::string_view name, int run);

namespace dialects {

/// Columns without values, named by the header or "column N".
std::vector<Column> name_columns(const Header& header, std::size_t count);

/// A column without a name becomes "column N".
void number_unnamed(std::vector<Column>& columns);

/// A delimiter at the end of each row makes an empty column without a name: dropped. One column stays.
void drop_unnamed_empty(std::vector<Column>& columns);

/// Numbers the runs from 1 in the file's order. A run begins where the file names one, or where a column's
/// name repeats.
void number_runs(Recording& recording, const Header& header);

/// Marks the time columns: the one asked for, else those that are called a time, else a first column that
/// rises evenly.
Result<void> mark_time(Recording& recording, const ReadOptions& options, bool has_header);

/// Adds notices of missing values. The rows that a shorter run does not have are not missing.
void count_missing(Recording& recording);

}  // namespace dialects
}  // namespace cromer::core
