// From the bytes of a logger's file to a table: dialect, header, types, time, as named stages. Pure: no files
// here.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/table.h"
#include "cromer/read.h"
#include "cromer/result.h"

namespace cromer::core {

struct Gap {
  double t;       // [s] where it begins
  double length;  // [s]
};

struct Outlier {
  double t;  // [s]
  double value;
  long line;  ///< of the file, from 1
};

/// How the file was written.
struct Dialect {
  std::string name;       ///< "PASCO Capstone", "Tracker", "plain", ...
  std::string encoding;   ///< "UTF-8", "UTF-8 with BOM", "UTF-16 LE", "cp1252", ...
  std::string separator;  ///< "comma", "semicolon", "tab", "blanks"
  std::string decimal;    ///< "point" or "comma"
};

/// A file read. Units are the file's own; times are seconds.
struct Recording {
  std::string file;
  Dialect dialect;
  Table table;              ///< without bad rows; ragged runs padded with NaN
  bool named = false;       ///< the file itself names its columns
  std::vector<long> lines;  ///< line number in the file of each row
  /// Where tables stand below each other in the file or in an archive: the lines of each, and which of them a
  /// column stands in; `lines` is empty then, else these are.
  std::vector<std::vector<long>> lines_of_set;
  std::vector<std::size_t> set_of_column;
  std::vector<Notice> notices;
  std::string motion{};  ///< what was recorded where, without its direction, where the file says so
};

/// Reads a whole file. An Error names file, line, column and cure: `lab.csv:17: column "Position (m)": "abc"
/// is not a number; ...`.
Result<Recording> read_recording(std::string_view bytes, std::string_view file, const ReadOptions& options);

/// The line of the file that holds a column's value in a row of the table.
inline long line_of(const Recording& recording, std::size_t column, std::size_t row) {
  if (recording.lines_of_set.empty()) return recording.lines[row];
  const std::vector<long>& lines = recording.lines_of_set[recording.set_of_column[column]];
  return row < lines.size() ? lines[row] : 0;
}

/// One quantity of one run with its times, missing values left out, times made strictly increasing;
/// everything repaired is said in notices.
struct Series {
  std::string column;    ///< as the file names it, with unit
  std::string quantity;  ///< position, angle, ...
  std::string unit;      ///< as spelled
  double to_si = 1;      ///< value in SI = to_si * y
  int run = 1;
  std::string time_column;  ///< "" if the times come from --rate
  std::vector<double> t;    // [s]
  std::vector<double> y;    ///< in SI units
  std::vector<long> lines;
  double rate = 0;        // [1/s] one over the median step, rounded as far as the times agree; or --rate
  double jitter = 0;      ///< standard deviation of the steps over their median; 0 with --rate
  double resolution = 0;  ///< rounding step of the values in SI, 0 if none is seen
  std::vector<Gap> gaps;  ///< where samples are missing
  std::vector<Outlier> outliers;  ///< listed here, and left in t and y
  std::vector<Notice> notices;
};

/// The unit of y: of its quantity, else the file's own where values are taken as they are; "" where it has no
/// name.
std::string unit_of(const Series& series);

/// The runs of a recording: 1, 2, ...
std::vector<int> runs(const Recording& recording);

/// Picks a column: `column` matched exactly, else without case, decoration and unit if unambiguous; empty: a
/// position is taken (else angle, angular velocity, velocity, acceleration); several alike, or several of
/// which only the names are known, are an Error that lists them. Its times are those of the time column
/// before it. `run` from 1.
Result<Series> take_series(const Recording& recording, std::string_view column, int run,
                           const ReadOptions& options);

/// Run by run: the time first, in seconds and strictly increasing (repeated and backward rows left out), then
/// the other columns in the file's own units, missing values NaN. Without a time column the times come from
/// `options.rate`; without either there is no time column. Reading the table back, written under
/// column_heading, gives it again.
Result<Table> clean_table(const Recording& recording, const ReadOptions& options);

/// "Position (mm)", and "Position (mm) Run #2" in a table of several runs.
std::string column_heading(const Table& table, std::size_t column);

}  // namespace cromer::core
