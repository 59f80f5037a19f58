// A record beside the motion of a law under a drive: residuals, normal equations, states.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/identify/motion/motion.h"
#include "cromer/identify/record.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// What acts on the motion beside its law: nothing, a harmonic force whose frequency is one of the motion's
/// own numbers, or a recorded force.
struct Drive {
  DriveKind kind = DriveKind::none;
  ForceRecord force{};  ///< where it is recorded; its samples outlive what uses it

  static Drive harmonic() { return {DriveKind::harmonic}; }
  static Drive recorded(const ForceRecord& force) { return {DriveKind::recorded, force}; }
};

/// Longest step [s] for which dormand-prince over `duration` keeps the motion within `error` times its
/// amplitude, which is off by (w h)^5/3600 a radian: that is (1/600 - 1/720) (w h)^6 a step, from the sixth
/// power in its growth factor. Between 1/600 and 1/20 of a period.
double motion_step(double angular_frequency, double duration, double error);

/// How many steps of at most h a motion takes through the times, its turns left out. To read a sample costs a
/// quarter of a step.
inline double steps_through(std::span<const double> t, double h) {
  return (t.back() - t.front()) / h + 0.25 * static_cast<double>(t.size());
}

/// Displacement and velocity at the times t [s], strictly increasing, of the motion that has its position and
/// velocity at t[0]. Steps of at most h. Shorter than t where the motion runs away. Times of a recorded
/// force's own only, beginning to end within it.
Trajectory motion_states(const Motion& motion, const Drive& drive, std::span<const double> t, double h);

/// What a record would show of it: that derivative of the displacement, and the equilibrium.
std::vector<double> observed_motion(const Motion& motion, const Drive& drive, std::span<const double> t,
                                    int derivative, double h);

/// data - model; fewer than the data where the motion runs away.
std::vector<double> motion_residuals(const Motion& motion, const Drive& drive, const Record& record,
                                     double h);

/// The normal equations at parameters packed as `fitted` says, at steps of at most h; their sum of squares is
/// infinite where the motion does not stay finite.
NormalEquations motion_equations(const FittedParameters& fitted, const Parameters& parameters,
                                 const Drive& drive, const Record& record, double h);

/// The Jacobian of what is observed, sample by sample: fitted.count numbers for each. Empty where the motion
/// does not stay finite.
std::vector<double> jacobian_of(const FittedParameters& fitted, const Parameters& parameters,
                                const Drive& drive, const Record& record, double h);

/// The rest that dry friction brings a free motion to.
struct Rest {
  std::size_t first = 0;    ///< sample from which it is at rest; the number of samples where it never is
  int half_swings = 0;      ///< before it
  double position = 0;      // [unit] from the equilibrium
  Parameters derivative{};  ///< of the position, in the order of the fitted parameters
};
/// At steps of at most h [s] > 0 through the record's times; `fitted` is of a law with friction and no drive.
Rest rest_of(const FittedParameters& fitted, const Parameters& parameters, const Record& record, double h);

/// Velocity after `duration` [s] of a free motion, and its derivatives in the order of the fitted parameters.
struct VelocityGradient {
  double velocity = 0;
  Parameters derivative{};
};
VelocityGradient velocity_gradient(const FittedParameters& fitted, const Motion& motion, double duration,
                                   double h);

}  // namespace cromer::core
