// Task: what is in a file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core {

/// What is known of one column of the table beside its name and values.
struct InspectedColumn {
  std::size_t samples = 0;  ///< values that are not missing
  std::string time_column;  ///< the one that goes with it, with unit; "" for a time, and if there is none
};

/// What `cromer inspect` says of the whole file, and of one column in each run. In JSON a column's name is
/// its title, "Time (s)", as time_column spells it. The options for columns take the title or the bare name.
struct Inspection {
  Recording recording;
  std::vector<InspectedColumn> columns;  ///< as in the table
  std::string column;                    ///< the one that is described, as the first run spells it
  std::vector<Series> series;            ///< one per run, of that column
  std::size_t samples = 0;               ///< rows of the longest run
  double rate = 0;                       // [1/s] 0 if unknown
  double duration = 0;                   // [s] 0 if unknown
  std::string time_column;
  double jitter = 0;
  std::vector<Gap> gaps;
  std::vector<Outlier> outliers;
  std::vector<Notice> notices;
};

/// `column` is the one to describe, named as in --column; empty: the one that a fit would take, or the first
/// of several alike. A run without it has a notice instead of a series.
Result<Inspection> inspect(Recording recording, const ReadOptions& options, std::string_view column = "");

}  // namespace cromer::core
