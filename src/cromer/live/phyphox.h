// What the phone's app phyphox says over HTTP: its experiment, and what its buffers hold. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/live/rows.h"
#include "cromer/result.h"

namespace cromer::core {

/// The buffers recorded: a time and the values that are measured at it.
struct PhyphoxSet {
  std::string experiment;            ///< its title
  std::vector<std::string> buffers;  ///< the time's first
  Headings headings;                 ///< of each: "Time (s)", "Linear Acceleration x (m/s^2)", ...
};

/// From the answer to /config: the first exported set with a time, else the first sensor with one. An
/// experiment without a time is an Error that names it.
Result<PhyphoxSet> read_phyphox_config(std::string_view json);

/// "/get?t=full&y=full", or with `after` [s] only what came later: "/get?t=12.5&y=12.5|t".
std::string phyphox_query(const PhyphoxSet& set, std::optional<double> after);

struct PhyphoxAnswer {
  Rows rows;               ///< all values, NaN where the phone says null; rows without a time are left out
  std::size_t uneven = 0;  ///< values at the ends of longer buffers that had no partner yet
  bool measuring = false;
};

/// From the answer to phyphox_query. Buffers that are filled while they are read are cut to the shortest; a
/// missing buffer and text that is no answer are Errors.
Result<PhyphoxAnswer> read_phyphox_answer(std::string_view json, const PhyphoxSet& set);

}  // namespace cromer::core
