// The free motion of any law of this folder, integrated with its derivatives.
//
//   x'' = -w0^2 x - 2 g x' - q x'|x'| - f sgn x' - k3 x^3,   x measured from the equilibrium
//
// with q = d/m, f and k3 per mass; for a pendulum w0^2 sin x in place of w0^2 x. A record of velocities or
// accelerations is compared with x' or x'' + the equilibrium, which then is the sensor's offset; all else
// stays what it is of the displacement x, whose unit is that of the record times s or s^2.
#pragma once

#include <cstddef>
#include <span>

#include "cromer/identify/law.h"
#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/identify/record.h"
#include "cromer/run/trajectory.h"

namespace cromer {

/// The numbers that fix one motion; terms that a law lacks are 0.
struct MotionParameters {
  double angular_frequency = 0;  // [rad/s] w0, undamped
  double decay_rate = 0;         // [1/s] g
  double drag = 0;               // [1/unit] q
  double friction = 0;           // [unit/s^2] f
  double cubic = 0;              // [1/(s^2 unit^2)] k3
  double equilibrium = 0;        // [unit of the record]
  double position = 0;           // [unit] from the equilibrium, at the first time
  double velocity = 0;           // [unit/s] at the first time
  bool pendulum = false;         // the restoring force goes with sin x
};

/// Which of them a law fits, in the order angular_frequency, decay_rate, drag, friction, cubic, equilibrium,
/// position, velocity.
struct FittedParameters {
  int count = 0;
  bool pendulum = false;  ///< of the law
  double MotionParameters::*member[max_parameters]{};
  const char* name[max_parameters]{};
};
FittedParameters fitted_parameters(const Law& law);

Parameters pack(const FittedParameters& fitted, const MotionParameters& motion);
MotionParameters unpack(const FittedParameters& fitted, const Parameters& parameters);

/// Longest step [s] for which dormand-prince over `duration` keeps the motion within `error` times its
/// amplitude, which is off by (w h)^5/3600 a radian: that is (1/600 - 1/720) (w h)^6 a step, from the sixth
/// power in its growth factor. Between 1/600 and 1/20 of a period.
double motion_step(double angular_frequency, double duration, double error);

/// Displacement and velocity at the times t [s], strictly increasing, starting from position and velocity at
/// t[0]. Steps of at most h.
Trajectory free_motion(const MotionParameters& motion, std::span<const double> t, double h);

/// data - model, at steps of at most h; fewer than the data where the motion runs away.
std::vector<double> motion_residuals(const MotionParameters& motion, const Record& record, double h);

/// The normal equations of the law at parameters packed as fitted_parameters(law) says, at steps of at most
/// h; derivatives by dual numbers.
NormalEquations motion_equations(const Law& law, const Parameters& parameters, const Record& record,
                                 double h);

/// The rest that dry friction brings a motion to.
struct Rest {
  std::size_t first = 0;    ///< sample from which it is at rest; the number of samples where it never is
  int half_swings = 0;      ///< before it
  double position = 0;      // [unit] from the equilibrium
  Parameters derivative{};  ///< of the position, in the order of fitted_parameters(law)
};
Rest rest_of(const Law& law, const Parameters& parameters, const Record& record, double h);

/// Velocity at time t (from t0, where the motion starts) and its derivatives in the order of
/// fitted_parameters(law).
struct VelocityGradient {
  double velocity = 0;
  Parameters derivative{};
};
VelocityGradient velocity_gradient(const Law& law, const MotionParameters& motion, double duration, double h);

}  // namespace cromer
