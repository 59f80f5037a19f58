// From the record of a forced motion to its law.
//
//   x'' = force_gain (u(t) + force_offset) - w0^2 x - 2 g x' - q x'|x'| - k2 x^2 - k3 x^3,   x = y -
//   equilibrium
//
// The whole waveform is fitted, beginning included; no start values are asked for. A record of velocities or
// accelerations is fitted as what it is: then the equilibrium is the sensor's offset.
//
// Force offset, equilibrium and quadratic stiffness: any one of them can be traded for the other two without
// changing the motion (a shift of x turns a cubic into a cubic), so that no record tells all three. An
// instrument whose zero lies amid the motion is taken to have been set to zero where the spring is at rest:
// its equilibrium is 0, and the force's offset is fitted. Where the zero is elsewhere, the force's is trusted
// instead.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "cromer/identify/forced_law.h"
#include "cromer/identify/free_decay.h"
#include "cromer/identify/motion/recorded_force.h"
#include "cromer/run/trajectory.h"

namespace cromer {

/// A record of the motion with the force that acted.
struct ForcedRecord {
  std::span<const double> force;  ///< every `spacing`, before and after the motion as well if there is more
  double spacing = 1;             // [s] > 0
  std::size_t first = 0;          ///< the force's sample at which the motion begins
  std::span<const double> t;      // [s] of the motion, every `spacing`; force.size() >= first + t.size()
  std::span<const double> y;      ///< NaN where a sample is missing or set aside
  std::size_t fitted = 0;         ///< how many of the motion's samples the fit may see
  double resolution = 0;          ///< rounding step of y, 0 if unknown
  int derivative = 0;             ///< 1 or 2 where y are velocities or accelerations
};

struct ForcedFit {
  /// Status, law (its cubic with the quadratic term), estimates and residual over the fitted samples; names
  /// and covariance hold all quantities of the fit in the contract's order.
  FreeDecay law;
  std::optional<Estimate> quadratic;        // k2/m [1/(unit s^2)]
  std::optional<Estimate> force_gain;       // [unit/s^2 per unit of force]
  std::optional<Estimate> force_offset;     // [unit of force]
  std::optional<Estimate> drive_frequency;  // [rad/s]
  std::optional<Estimate> drive_amplitude;  // [unit/s^2] per unit mass
  std::optional<Estimate> drive_phase;      // [rad] at the first sample
  ForceBetween between = ForceBetween::linear;
  Parameters parameters{};     ///< in the order of forced_layout
  std::vector<double> motion;  ///< y of the law at every time of the record, unfitted ones included
  Trajectory states;           ///< displacement from the equilibrium and velocity there
};

/// Where a fit begins, and what it is up against.
struct ForcedStart {
  Parameters parameters{};
  double rms_to_beat = HUGE_VAL;  ///< a fit that leaves 1.2 times this is not refined any further
};

/// One law under one reading of the force. `start` is found if not given. Never throws; what cannot be fitted
/// is a status with a message.
ForcedFit fit_recorded_force(const ForcedRecord& record, ForcedTerms terms, ForceBetween between,
                             const std::optional<ForcedStart>& start = {}, const Watch& watch = {});

}  // namespace cromer
