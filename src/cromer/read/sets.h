// Tables and runs that share a file: sets below each other, channels, files of an archive, a time that starts
// again.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/table.h"
#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core::dialects {

/// Columns that share their rows. The run of a column is not looked at.
struct Set {
  std::string label;            ///< "Run #1", "Latest", "Raw Data"; sets with the same label are one run
  std::vector<Column> columns;  ///< of equal length
  std::vector<long> lines;      ///< line number in the file of each row
  long names_line = 0;          ///< line number in the file of the columns' names; 0: none
};

/// What the reader of a format is given.
struct Source {
  std::string_view text;  ///< UTF-8
  const std::vector<std::string_view>& lines;
  std::string_view file;
  const ReadOptions& options;
};

/// Whether a header's step of time [s] can be used: with a longer one the times would overflow.
inline bool is_step(double step) { return step > 0 && step < 1e12; }

/// What the reader of a format returns; later stages see to times and missing values.
struct Sets {
  std::string dialect;
  char separator = 0;
  char decimal = '.';
  std::vector<Set> sets;
  std::vector<Notice> notices;
  std::string motion{};  ///< as Recording has it
};

/// Lays the sets side by side as runs 1, 2, ... A set without a label, or with columns that its run has
/// already, begins a new run. A time that its run has already is not repeated. Sets of very unequal length
/// are an Error: padding them would cost far more memory than the file has bytes.
Result<void> lay_side_by_side(std::vector<Set> sets, Recording& recording);

/// Adds notices of what runs are called in the file, if not by their number.
void say_labels(const std::vector<std::string>& labels, std::vector<Notice>& notices);

/// The line indices at which tables begin; the first is 0. A table begins where the first header comes again,
/// or at a line of names above rows whose first name is a time; titles right above it belong to it.
std::vector<std::size_t> find_tables(const std::vector<std::string_view>& lines);

/// Reads each table by the common stages. Tables whose titles name the same "Run #N" are one run.
Result<Recording> read_tables(const std::vector<std::string_view>& lines,
                              const std::vector<std::size_t>& starts, const ReadOptions& options);

/// A recording taken apart into sets again, one for each run.
std::vector<Set> as_sets(Recording recording, const std::string& label);

/// Runs below each other, told apart by a first column "run" (the form of Cromer's own CSV files): puts them
/// side by side and drops that column. False, and nothing done, where the table is not of that form.
bool split_stacked_runs(Recording& recording);

/// A new run begins where the only time column starts again: puts the runs side by side, and says so.
void split_at_restarts(Recording& recording);

}  // namespace cromer::core::dialects
