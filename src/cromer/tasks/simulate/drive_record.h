// A recorded force or acceleration: from a recording to evenly spaced samples.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core {

/// How far samples of a recorded force may lie off an even grid, of a spacing.
inline constexpr double most_uneven = 0.02;

/// Evenly spaced samples in SI units, the first at the run's start.
struct DriveRecord {
  std::vector<double> values;  ///< at least two; all finite
  double spacing = 0;          // [s] > 0
  std::vector<Notice> notices;
  std::string column{};    ///< as the file names it, with unit
  std::string motion{};    ///< as Recording has it
  bool unit_known = true;  ///< if not, the values are as they stand in the file
};

/// What is wanted of a file, and how notices name it.
struct DriveRequest {
  std::string_view quantity;                        ///< "force" or "acceleration"
  std::string_view column{};                        ///< "": the only one that can be meant
  int run = 0;                                      ///< 0: the first
  std::string_view column_option = "drive-column";  ///< the option that names another column
  std::string_view use = "drive";                   ///< what the samples are for: "drive" or "spectrum"
};

/// An Error if the file holds no such recording: another quantity, gaps or missing values, uneven times.
Result<DriveRecord> drive_record(const Recording& recording, const DriveRequest& request,
                                 const ReadOptions& options);

}  // namespace cromer::core
