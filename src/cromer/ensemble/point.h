// One oscillator of many: what it is, how it is stepped, and what is kept of its motion.
#pragma once

#include <limits>
#include <string_view>

#include "cromer/base/state.h"
#include "cromer/methods/method_settings.h"
#include "cromer/model/oscillator.h"

namespace cromer::core {

/// An oscillator without friction, its drive, start and step.
struct Point {
  Oscillator<double> oscillator;
  HarmonicDrive<double> drive;
  State<double> start;
  double step = 0;  // [s] > 0
};

/// How all points are stepped.
struct Stepping {
  std::string_view method;  ///< of fixed steps, in the list
  MethodSettings settings{};
};

/// Files of rows store these as numbers: a new one comes last.
enum class PointStatus : unsigned char {
  done,            ///< settled, or run to its end
  not_settled,     ///< the motion still changed after the most cycles, or never stops changing
  not_finite,      ///< it ran away
  no_convergence,  ///< Newton's iteration found no solution in some step
  unstable,        ///< of a linear law: the method's free motion grows without end
  own_damping,     ///< settled by the method's own damping alone: the law has none
};

/// Whether a point of this status has numbers.
constexpr bool has_numbers(PointStatus status) {
  return status == PointStatus::done || status == PointStatus::own_damping;
}

/// What is kept of a motion. Numbers that do not exist are NaN: the amplitude of a motion without a drive,
/// all numbers of one that ran away.
struct PointResult {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  PointStatus status = PointStatus::done;
  double amplitude = none;  // [m] at the drive's frequency
  double phase_lag = none;  // [rad] behind the drive, -pi/2 to 3 pi/2
  double mean = none;       // [m] of the settled motion
  double rms = none;        // [m] of the settled motion, the mean included
  double peak = none;       // [m] largest |x| at the steps: after settling, or of the whole run
  double energy = none;     // [J] mean of the settled motion, or at the end of a run
  State<double> end{none, none};
  double end_time = 0;  // [s]
  double cycles = 0;    ///< of the drive until it had settled
};

}  // namespace cromer::core
