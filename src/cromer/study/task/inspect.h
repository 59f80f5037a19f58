// Task: what is in a file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/result.h"
#include "cromer/record/dialects/recording.h"

namespace cromer {

/// What is known of one column of the table beside its name and values.
struct InspectedColumn {
  std::size_t samples = 0;  ///< values that are not missing
  std::string time_column;  ///< the one it is taken with, with unit; "" of a time, and where there is none
};

/// In JSON a column's name is its title, "Time (s)": as time_column spells it, and as --column and
/// --time-column take it (they also take the bare name). What `cromer inspect` says: of the whole file, and
/// of the column that a fit would take in each run.
struct Inspection {
  Recording recording;
  std::vector<InspectedColumn> columns;  ///< as in the table
  std::vector<Series> series;            ///< one per run, of its main column
  std::size_t samples = 0;               ///< rows of the longest run
  double rate = 0;                       // [1/s] 0 if unknown
  double duration = 0;                   // [s] 0 if unknown
  std::string time_column;
  double jitter = 0;
  std::vector<Gap> gaps;
  std::vector<Outlier> outliers;
  std::vector<std::string> warnings;
};

Result<Inspection> inspect(std::string_view bytes, std::string_view file, const ReadOptions& options);

}  // namespace cromer
