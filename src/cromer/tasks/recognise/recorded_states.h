// The rows of a file as states at even times, and how finely they are written.
#pragma once

#include <cstddef>
#include <string>

#include "cromer/read/recording.h"
#include "cromer/result.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// Where they stand; "" and 0 mean: find out.
struct StateColumns {
  std::string position{}, velocity{};
  int run = 0;
};

struct RecordedStates {
  double spacing = 0;                  // [s]
  double spacing_error = 0;            ///< its relative standard error, from the rounding of the times
  Trajectory rows;                     ///< in SI units, at most most_recorded_states
  double x_rounding = 0;               // [m] rms of what rounding did to the positions
  double v_rounding = 0;               // [m/s] likewise
  bool single = false;                 ///< all values are numbers in single precision
  std::string position{}, velocity{};  ///< the columns' names
};

/// An Error if the run has no time, no position or no velocity, a value is missing, the times are uneven or
/// the rows too few.
Result<RecordedStates> recorded_states(const Recording& recording, const StateColumns& columns,
                                       const ReadOptions& options);

inline constexpr std::size_t fewest_states = 6, most_recorded_states = 600;

}  // namespace cromer::core
