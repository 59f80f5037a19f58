// The angle of a point that swings about a pivot, of its x and y: a pendulum on film.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cromer/base/table.h"
#include "cromer/result.h"

namespace cromer::core {

/// A circle, in the points' unit.
struct Arc {
  double x = 0, y = 0;  ///< its centre
  double radius = 0;
  double radius_error = 0;  ///< standard error, wider where the distances hang together from point to point
};

/// The circle on which points lie: of the least squares of their distances from it (N. Chernov, Circular and
/// Linear Regression (2010), chapters 4 and 5). Points without x or y (NaN) are left out, and so is up to a
/// tenth of them that lies far from it. Empty unless its radius is known to 5 % (one standard error) and less
/// than fifty times what the points spread (rms), and the distances (rms) are less than a twentieth of that.
std::optional<Arc> find_arc(std::span<const double> x, std::span<const double> y);

/// "angle(x,y)": how the angle of two columns is called.
std::string name_of_angle(const Column& x, const Column& y);

/// An angle that was computed of two columns.
struct ComputedAngle {
  Column angle;           ///< [rad]
  std::size_t place = 0;  ///< for it, behind the second of them
  Arc arc;
  std::size_t x = 0, y = 0;  ///< the places of the two columns
};

/// The angle from the middle of the swing, positive towards larger x, if `name` is that of an angle of two
/// columns of this run. Empty if it is no such name. An Error if there are no such columns, if they are of
/// different quantities or times, or if there is no arc.
Result<std::optional<ComputedAngle>> computed_angle(const Table& table, std::string_view name, int run);

}  // namespace cromer::core
