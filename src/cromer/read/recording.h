// From the bytes of a logger's file to a table: dialect, header, types, time, as named stages. Pure: no files
// here.
#pragma once

#include <cmath>
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

/// A file as it was read, in its own units.
struct Recording {
  std::string file;
  Dialect dialect;
  Table table;              ///< without bad rows; ragged runs padded with NaN
  bool named = false;       ///< the file itself names its columns
  std::vector<long> lines;  ///< line number in the file of each row
  /// For several tables in one file or archive: the line numbers of each, and the table that each column is
  /// of. `lines` is empty then; for a single table these two are.
  std::vector<std::vector<long>> lines_of_set;
  std::vector<std::size_t> set_of_column;
  std::vector<Notice> notices;
  std::string motion{};  ///< event, date and station without the direction, if the file names them
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

/// One quantity of one run with its times. Missing values are left out and times rise strictly; notices say
/// what was repaired.
struct Series {
  std::string column;    ///< as the file names it, with unit
  std::string quantity;  ///< position, angle, ...
  std::string unit;      ///< as spelled
  double to_si = 1;      ///< value in SI = to_si * y
  int run = 1;
  std::string time_column;  ///< "" if the times come from a given rate
  std::vector<double> t;    // [s]
  std::vector<double> y;    ///< in SI units
  std::vector<long> lines;
  double rate = 0;    // [1/s] one over the median step, rounded as far as the times agree; or the rate given
  double jitter = 0;  ///< standard deviation of the steps over their median; 0 with a given rate
  double clock_error = 0;      ///< relative standard error of the spacing that rounded times stand for
  double scale_error = 0;      ///< relative standard error of the unit of y, of an angle that was computed
  double arc_radius = 0;       // [m] of an angle that was computed; 0 where the unit is not known
  double slips_at = HUGE_VAL;  ///< [s] from when on t was shifted back, for a slip of the recorder's times
  double slips_by = 0;         ///< [s] by so much
  double handled_first = 0, handled_last = 0;  // [s] of its ends, that may not be free of a hand
  double resolution = 0;                       ///< rounding step of the values in SI, 0 if none is seen
  std::vector<Gap> gaps;                       ///< where samples are missing
  std::vector<Outlier> outliers;               ///< listed here, and left in t and y
  std::vector<Notice> notices;
};

/// The unit of y: the SI unit of its quantity, else the file's own if values are not converted, else "".
std::string unit_of(const Series& series);

/// The runs of a recording: 1, 2, ...
std::vector<int> runs(const Recording& recording);

/// An Error if there is no such run.
Result<void> check_run(const Recording& recording, int run);

/// The columns of a run that may be the motion: its positions, else its angles, angular velocities,
/// velocities or accelerations.
std::vector<std::size_t> motion_columns(const Recording& recording, int run);

/// Takes one column of a run (from 1) as a series. `column` is matched exactly, else without case, decoration
/// and unit; "angle(x,y)" is computed (angle_about_pivot.h). If it is empty, the one of motion_columns() is
/// taken.
/// Several that fit, or several of which only the names are known, are an Error that lists them. The times
/// are those of the time column before it.
Result<Series> take_series(const Recording& recording, std::string_view column, int run,
                           const ReadOptions& options);

/// A recording as one clean table, run by run: first the time in seconds, strictly increasing (rows with
/// repeated and backward times are left out), then the other columns in the file's own units, missing values
/// NaN. Without a time column the times come from `options.rate`; without a rate there are none. Written
/// under column_heading and read back, the table is the same.
Result<Table> clean_table(const Recording& recording, const ReadOptions& options);

/// "Position (mm)", and "Position (mm) Run #2" in a table of several runs.
std::string column_heading(const Table& table, std::size_t column);

}  // namespace cromer::core
