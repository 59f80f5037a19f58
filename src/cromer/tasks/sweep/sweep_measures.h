// What a sweep keeps of each point: names, columns, and the numbers themselves.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/ensemble/point.h"
#include "cromer/result.h"

namespace cromer::core {

/// One name of --measure.
struct Measure {
  std::string_view name;
  bool of_settled_motion;  ///< there only where a drive keeps the motion going
  bool in_closed_form;     ///< known of a linear law without stepping
  std::vector<std::string> columns;
  void (*write)(const PointResult& result, double* to);
};

/// All of them.
const std::vector<Measure>& measures();

/// By names, also several with commas; what is usual where none is given. An Error suggests the nearest name.
Result<std::vector<const Measure*>> find_measures(const std::vector<std::string>& names, bool driven);

}  // namespace cromer::core
