// The points of a sweep, one by one and quickly: from a row's number to the oscillator.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/grid.h"
#include "cromer/base/result.h"
#include "cromer/ensemble/point.h"
#include "cromer/study/task/option.h"
#include "cromer/study/task/simulate.h"

namespace cromer {

/// An option's grid.
struct SweepAxis {
  std::string name;  ///< as typed
  std::string unit;  ///< SI
  Grid grid;
};

/// The point that options with one value each describe, its end (that of --until, or the default), or an
/// Error.
struct SweepPoint {
  Point point;
  double until = 0;        // [s]
  double loss_factor = 0;  ///< of hysteretic damping; then there is no damper
};
Result<SweepPoint> sweep_point_of(const SimulateOptions& options);

/// Turns row numbers into points. One for each thread.
class SweepPoints {
 public:
  /// Both outlive it. The last axis runs fastest.
  SweepPoints(const SimulateOptions& base, const std::vector<SweepAxis>& axes);
  SweepPoints(const SweepPoints&) = delete;
  SweepPoints& operator=(const SweepPoints&) = delete;

  /// The values of the axes in that row, one for each.
  void values_of(std::uint64_t row, double* values) const;

  /// The point with these values.
  Result<SweepPoint> at(const double* values);

 private:
  const std::vector<SweepAxis>& axes_;
  SimulateOptions options_;
  std::vector<Option::Target> targets_;
};

/// Puts a number into an option's target, whatever it is.
void set_number(const Option::Target& target, double value);

}  // namespace cromer
