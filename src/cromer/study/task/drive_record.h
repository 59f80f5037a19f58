// A recorded drive: from a file's bytes to evenly spaced samples.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/result.h"
#include "cromer/record/dialects/recording.h"

namespace cromer {

/// Evenly spaced samples in SI units, the first at the run's start.
struct DriveRecord {
  std::vector<double> values;  ///< at least two; all finite
  double spacing = 0;          // [s] > 0
  std::vector<std::string> warnings;
};

/// `quantity` is "force" or "acceleration"; `column` may be empty where only one can be meant. An Error for
/// what is no such recording: another quantity, gaps or missing values, times that are not even.
Result<DriveRecord> read_drive_record(std::string_view bytes, std::string_view file,
                                      std::string_view quantity, std::string_view column,
                                      const ReadOptions& options);

}  // namespace cromer
