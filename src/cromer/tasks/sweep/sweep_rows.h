// The rows of a sweep: from a row's number to the point, its motion, and the measures of it.
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
  GridUnit typed{};  ///< the unit it was typed in
};

/// Whether the option is a setting of the method (tolerance, beta, gamma, rho-inf), which all lanes of a
/// group share.
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
  /// `axes` must outlive it; the last one runs fastest.
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
  std::vector<std::optional<Option::Target>> targets_;  ///< empty: no option (direction)
  MethodSettings settings_;                             ///< if no axis is one of them
  bool settings_vary_ = false;
};

/// Stores a number in an option's target of any type that takes one.
void set_number(const Option::Target& target, double value);

/// One name of --measure.
struct Measure {
  std::string_view name;
  bool of_settled_motion;  ///< exists only under a drive that keeps the motion going
  bool in_closed_form;     ///< known of a linear law without stepping
  std::vector<std::string> columns;
  void (*write)(const PointResult& result, const Point& point, double* to);
  bool of_base = false;  ///< compares the motion with that of a shaking base
};

/// The measures of these names, also several with commas; without names the usual ones. An Error suggests the
/// nearest name.
Result<std::vector<const Measure*>> find_measures(const std::vector<std::string>& names, bool driven);

/// How the points are computed.
enum class SweepWay {
  closed_form,  ///< of the method's map: a linear law's settled motion
  settled,      ///< stepped in groups until the motion has settled
  to_end,       ///< stepped in groups for a given time
  one_by_one,   ///< with friction, or steps that the method chooses: run by run
};

/// With a direction, each point along the last axis starts where the one before ended. `both`:
/// the first axis is the direction, 1 up and -1 down.
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

  /// For a given time, or without a drive: nothing has to settle.
  bool runs_to_end() const { return base.until.has_value() || !driven; }

  Stepping stepping(const MethodSettings& settings) const { return {method, settings}; }
  std::size_t columns() const;  ///< axes, measures, status

  /// Rows of a chunk: few enough to share among threads, many enough to be worth it.
  std::uint64_t rows_per_chunk() const;

  /// Rows that follow each other with the same settings of the method. Their axes come before all others but
  /// the direction.
  std::uint64_t rows_of_equal_settings() const;
};

/// Makes `count` rows from `first` on; false if interrupted.
bool make_rows(const SweepWork& work, std::uint64_t first, std::uint64_t count, double* rows,
               const Watch& watch);

/// Steps one point until it settles, to check a closed form. Empty if interrupted.
std::optional<PointResult> settle_one(const SweepWork& work, const SweepPoint& at, const Watch& watch);

/// The settled motion of a linear law, from the method's map.
PointResult closed_form(const SweepWork& work, const SweepPoint& at);

/// Runs one point to the end, or until its motion settles. Empty if interrupted.
std::optional<PointResult> run_point(const SweepWork& work, const SweepPoint& point, const Watch& watch);

/// The method's own damping: the decay rate of the free motion [1/s] that it simulates of an undamped linear
/// law. Empty if nothing oscillates.
std::optional<double> own_decay_rate(const SweepWork& work, const MethodSettings& settings,
                                     const Point& point);

/// The options that make a point of a sweep: those of simulate, and the loss factor.
std::vector<Option> point_options(SimulateOptions& options);

/// Whether the sweep's springs have a loss factor.
bool has_loss_factor(const SweepOptions& options);

/// Checks that a loss factor suits the rest: the steady state of a linear law without a damper, in closed
/// form. `work` must have its method and base. An Error names the option and the cure.
Result<void> check_loss_factor(const SweepOptions& options, const SweepWork& work);

/// Checks that a sweep with a loss factor is driven, and measures settled motion alone. `work` must have its
/// measures.
Result<void> check_settled_loss(const SweepOptions& options, const SweepWork& work);

}  // namespace cromer::core
