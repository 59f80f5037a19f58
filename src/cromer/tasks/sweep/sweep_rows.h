// The rows of a sweep: from a row's number to an oscillator, what its motion comes to, and what is kept of
// it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/grid.h"
#include "cromer/base/interrupt.h"
#include "cromer/ensemble/dispatch.h"
#include "cromer/ensemble/point.h"
#include "cromer/ensemble/run_group.h"
#include "cromer/result.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/sweep/sweep.h"

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

/// One name of --measure.
struct Measure {
  std::string_view name;
  bool of_settled_motion;  ///< there only where a drive keeps the motion going
  bool in_closed_form;     ///< known of a linear law without stepping
  std::vector<std::string> columns;
  void (*write)(const PointResult& result, double* to);
};

/// By names, also several with commas; what is usual where none is given. An Error suggests the nearest name.
Result<std::vector<const Measure*>> find_measures(const std::vector<std::string>& names, bool driven);

/// Where the numbers come from.
enum class SweepWay {
  closed_form,  ///< of the method's map: a linear law's settled motion
  settled,      ///< stepped in groups until the motion has settled
  to_end,       ///< stepped in groups for a given time
  one_by_one,   ///< with friction, or steps that the method chooses: run by run
};

/// Hysteresis: along the last axis each point starts where the one before ended. Both: the first axis says
/// which, 1 up and -1 down.
enum class SweepDirection { none, up, down, both };
inline constexpr std::string_view direction_axis = "direction";

/// All that the rows depend on.
struct SweepWork {
  SimulateOptions base{};
  std::vector<SweepAxis> axes{};  ///< those of the method's settings first; the last runs fastest
  std::vector<const Measure*> measures{};
  SweepWay way = SweepWay::settled;
  SweepDirection direction = SweepDirection::none;
  Settling settling{};
  KernelUnit unit{};
  std::string method{};
  bool driven = false;  ///< by a force that swings, at the highest values of the grids

  /// For a given time, or without a drive: nothing is waited for.
  bool runs_to_end() const { return base.until.has_value() || !driven; }

  Stepping stepping(const MethodSettings& settings) const { return {method, settings}; }
  std::size_t columns() const;  ///< axes, measures, status

  /// Rows that one chunk has: few enough to share out, many enough to be worth it.
  std::uint64_t rows_per_chunk() const;

  /// Rows that follow each other with the same settings of the method: its axes come before all others but
  /// the direction.
  std::uint64_t rows_of_equal_settings() const;
};

/// Makes `count` rows from `first` on. False: interrupted.
bool make_rows(const SweepWork& work, std::uint64_t first, std::uint64_t count, double* rows,
               const Watch& watch);

/// One point by stepping, alone: what a closed form is checked by.
std::optional<PointResult> settle_one(const SweepWork& work, const SweepPoint& at, const Watch& watch);

/// The settled motion of a linear law from the map of the method.
PointResult closed_form(const SweepWork& work, const SweepPoint& at);

/// Run by run: to the end, or until the motion settles. Empty: interrupted.
std::optional<PointResult> run_point(const SweepWork& work, const SweepPoint& point, const Watch& watch);

/// The decay rate of the free motion [1/s] that the method has of an undamped linear law: its own damping.
/// Empty where nothing oscillates.
std::optional<double> own_decay_rate(const SweepWork& work, const MethodSettings& settings,
                                     const Point& point);

/// The options that make a point of a sweep: those of simulate, and the loss factor.
std::vector<Option> point_options(SimulateOptions& options);

/// Whether the sweep's springs have a loss factor.
bool has_loss_factor(const SweepOptions& options);

/// That what else is asked for can be told of it: a steady state of the linear law, no damper, closed form.
/// Called when `work` has its method and base. An Error names the option and the cure.
Result<void> check_loss_factor(const SweepOptions& options, const SweepWork& work);

/// That there is a settled motion and that it is what is measured, once `work` knows.
Result<void> check_settled_loss(const SweepOptions& options, const SweepWork& work);

}  // namespace cromer::core
