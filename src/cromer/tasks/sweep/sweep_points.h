// The points of a sweep, one by one and quickly: from a row's number to the oscillator.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/grid.h"
#include "cromer/ensemble/point.h"
#include "cromer/result.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// An option's grid.
struct SweepAxis {
  std::string name;  ///< as typed
  std::string unit;  ///< SI
  Grid grid;
  GridUnit typed{};  ///< what people read it in
};

/// Whether it is one of a method's own settings, which all lanes of a group share: tolerance, beta, gamma,
/// rho-inf.
bool is_method_setting(std::string_view option);

/// A point, its end (that of --until, or the default), and what its method is set to.
struct SweepPoint {
  Point point;
  double until = 0;        // [s]
  double loss_factor = 0;  ///< of hysteretic damping; then there is no damper
  MethodSettings settings{};
};

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

  /// What the method is set to in that row.
  MethodSettings settings_of(std::uint64_t row);

 private:
  void set_options(const double* values);

  const std::vector<SweepAxis>& axes_;
  SimulateOptions options_;
  std::vector<std::optional<Option::Target>> targets_;  ///< empty: of no option
  MethodSettings settings_;                             ///< where no axis is one of them
  bool settings_vary_ = false;
};

/// Puts a number into an option's target, whatever it is.
void set_number(const Option::Target& target, double value);

}  // namespace cromer::core
