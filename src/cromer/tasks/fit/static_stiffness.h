// The spring constant the static way: how far known masses stretch the spring.
//
//   extension = extension_0 + (g/k) mass
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/analysis/line.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// A mass at rest: the mean of its samples.
struct Hold {
  std::string file;
  int run = 1;
  double from = 0, to = 0;  // [s]
  std::size_t samples = 0;
  double position = 0;        // [m]
  double scatter = 0;         // [m] standard deviation of the samples
  double standard_error = 0;  // [m] of the mean, widened for correlation
  bool moves = false;         ///< slowly, as a swing does, not from sample to sample as noise
  Quantity mass;              // [kg]
};

struct StaticStiffness {
  std::vector<Hold> holds;
  LineWithErrors line;  ///< position [m] against mass [kg]
  Estimate stiffness;   // [N/m]
  Quantity gravity;     // [m/s²]
  std::vector<Notice> notices;
};

/// Samples at rest, one hold for each run if there are as many runs as `masses`, else the so many plateaus of
/// one run, in their order in time. A column of another quantity than a position, and plateaus that cannot be
/// told apart or are more or fewer than the masses, are Errors.
Result<std::vector<Hold>> find_holds(const std::vector<Series>& runs, std::string_view file,
                                     const std::vector<Quantity>& masses);

/// The weighted line, errors in both coordinates. What the means scatter more than their own errors (hooking
/// masses on, friction, creep) is found from the line and added; with three masses that rests on one degree
/// of freedom, and the interval says so. Fewer than two holds, or all masses alike, are Errors.
Result<StaticStiffness> static_stiffness(std::vector<Hold> holds, const Quantity& gravity);

}  // namespace cromer::core
