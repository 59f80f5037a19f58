// The rows of a sweep: how the points of a chunk are found.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/ensemble/dispatch.h"
#include "cromer/ensemble/point.h"
#include "cromer/ensemble/run_group.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/sweep/sweep_measures.h"
#include "cromer/tasks/sweep/sweep_points.h"

namespace cromer::core {

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

}  // namespace cromer::core
