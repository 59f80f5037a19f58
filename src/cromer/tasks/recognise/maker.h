// A method that may have made the rows of a file, and how near its states can come to them.
#pragma once

#include <cstddef>
#include <limits>
#include <string_view>

#include "cromer/base/state.h"
#include "cromer/methods/method_settings.h"
#include "cromer/model/oscillator.h"
#include "cromer/tasks/recognise/recorded_states.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// A method with a number of steps from row to row.
struct Maker {
  std::string_view method;
  MethodSettings settings{};
  long long steps_per_row = 1;  ///< 1 of methods whose states show no step
  bool velocity_ahead = false;  ///< the velocity of a row is that of one step later
  bool begun_before = false;    ///< the first row is not the start of the run

  /// Its states depend on the length of its steps.
  bool shows_steps() const;
};

/// What is not known exactly: the first state, which is rounded, the spacing where the times are rounded, and
/// the linear law where none is given.
struct Origin {
  State<double> start{};
  double spacing = 0;  // [s]
  Oscillator<double> law{};
};

/// Whether a run keeps an acceleration of its own, which no file shows.
bool carries_acceleration(const Maker& maker);

/// The first rows that are not compared: within a run a method's own acceleration may be any at the first
/// row, and its influence dies out within some steps.
std::size_t rows_left_out(const Maker& maker, std::size_t rows);

/// The states of the first `rows` rows; fewer if the run ends early.
Trajectory states_made_by(const Maker& maker, const Origin& origin, std::size_t rows);

/// How far states are from each other: the rms of the differences, positions over the rms of the positions,
/// velocities over that of the velocities.
struct Yardstick {
  double x = 1, v = 1;  // [m], [m/s] rms of the rows

  double distance(const Trajectory& one, const Trajectory& other) const;
};

/// Which unknowns a fit may move.
struct Freedom {
  double spacing_error = 0;  ///< relative; 0: the spacing is known
  double rounding = 0;       ///< of the rows, as a distance > 0: what weighs rows against times
  bool law = false;          ///< stiffness and damping
};

struct MakerFit {
  Origin origin{};
  double distance = std::numeric_limits<double>::infinity();  ///< so where the method does not get through
};

/// The origin from which the method comes nearest to the rows, by Gauss and Newton's iteration from a guess.
MakerFit fit_maker(const Maker& maker, const Trajectory& rows, const Yardstick& yardstick,
                   const Freedom& freedom, const Origin& guess, int iterations);

}  // namespace cromer::core
