// A motion with dry friction, phase by phase: it slides until its velocity vanishes, then slides on the other
// way or sticks until the pull on it exceeds what friction can hold.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <utility>

#include "cromer/base/function_ref.h"
#include "cromer/base/interrupt.h"
#include "cromer/base/state.h"
#include "cromer/run/course.h"
#include "cromer/run/keep.h"
#include "cromer/run/root.h"

namespace cromer::core {

/// A system with dry friction: sliding(direction) is the smooth system of a phase (direction 1 or -1),
/// pull(t, x) what friction must balance to hold it at rest, holding() the most it can [m/s^2]. If it
/// depends_on_time, next_turn(t) is the first time after t at which the pull may turn or jump.
template <class S>
concept FrictionSystem = requires(const S& system, double t, double x) {
  system.sliding(1);
  { system.pull(t, x) } -> std::convertible_to<double>;
  { system.holding() } -> std::convertible_to<double>;
};

/// The system of a sliding phase.
template <FrictionSystem S>
using SlidingSystem = decltype(std::declval<const S&>().sliding(1));

/// Which way a mass at rest at x starts to slide, 1 or -1; 0 if it sticks.
template <FrictionSystem S>
int direction_from_rest(const S& system, double t, double x) {
  const double pull = system.pull(t, x);
  return std::abs(pull) > system.holding() ? (pull > 0 ? 1 : -1) : 0;
}

/// The mass sticks: records rows until the pull exceeds what friction holds, a moment found to rounding, and
/// returns the direction of the slide that begins; 0 at the end of the run. The pull is looked at wherever
/// it may turn or jump, on both sides, so that no moment is missed. Without a drive nothing is computed.
template <FrictionSystem S>
int stick(const S& system, const Rows& rows, Course<double>& course, AnyRecorder record, const Watch& watch) {
  course.y.v = 0;
  course.at_rest = false;
  const double x = course.y.x;
  while (course.goes_on(rows)) {
    if (course.row % 1024 == 0 && watch.interrupted()) {
      course.interrupted = true;
      course.status = Status::stopped_by_event;
      break;
    }
    const double next = rows.time(course.row + 1);
    if constexpr (S::depends_on_time) {
      while (course.t < next) {
        const double from = course.t, turn = system.next_turn(from);
        const double to = turn > from ? std::min(turn, next) : next;
        for (const double at : {std::nextafter(to, from), to})
          if (const int direction = direction_from_rest(system, at, x); direction != 0) {
            const auto excess = [&](double t) { return direction * system.pull(t, x) - system.holding(); };
            course.t = find_root(excess, from, excess(from), at, excess(at));
            return direction;
          }
        course.t = to;
      }
    }
    course.t = next;
    ++course.row;
    record(course.t, course.y);
  }
  return 0;
}

/// Runs phase by phase: slide(direction) goes on with the smooth system of a phase until the velocity
/// vanishes (course.at_rest) or the run ends.
template <FrictionSystem S>
void stick_and_slip(const S& system, const Rows& rows, Course<double>& course,
                    FunctionRef<void(int direction)> slide, AnyRecorder record, const Watch& watch) {
  int direction =
      course.y.v != 0 ? (course.y.v > 0 ? 1 : -1) : direction_from_rest(system, course.t, course.y.x);
  while (course.goes_on(rows)) {
    if (direction == 0) {
      direction = stick(system, rows, course, record, watch);
    } else {
      slide(direction);
      if (course.at_rest) direction = direction_from_rest(system, course.t, course.y.x);
    }
  }
}

}  // namespace cromer::core
