// Columns of one kind that were recorded together.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cromer/read/recording.h"
#include "cromer/result.h"

namespace cromer::core {

/// One of them.
struct Channel {
  std::string column{};     ///< as the file names it, with unit
  std::vector<double> y{};  ///< in SI units, as long as the times; NaN where missing or set aside
  double resolution = 0;    ///< rounding step of the values in SI, 0 if none is seen
  std::size_t missing = 0;  ///< so many are NaN
};

/// At common times, which increase strictly.
struct Channels {
  std::string quantity{};  ///< of all: position, acceleration, ...
  std::string unit{};      ///< of the values below
  int run = 1;
  std::vector<double> t{};  // [s] each time that one of them has a value at
  double rate = 0;          // [1/s]
  std::vector<Channel> each{};
  std::vector<Notice> notices{};  ///< what take_series() says of them, said once
};

/// All motion_columns() of a run, each taken as take_series() takes it; samples that stick out are missing,
/// and all of a column without values. An Error if there are none, or several runs and none is named.
Result<Channels> take_channels(const Recording& recording, const std::optional<int>& run,
                               const ReadOptions& options);

/// Keeps the times between these [s], as samples_between() has them.
Result<void> crop(Channels& channels, const std::optional<double>& from, const std::optional<double>& to);

/// Whether all values of the channel are the same, missing ones apart.
bool never_changes(const Channel& channel);

/// Keeps the times at which all channels have values, and returns how many others there were.
std::size_t leave_out_incomplete(Channels& channels);

}  // namespace cromer::core
