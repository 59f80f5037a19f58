// The extremes of a quantity of the linear law between two samples of its drive, and after the drive's end.
#pragma once

#include <algorithm>
#include <cmath>

#include "cromer/analysis/response_filter.h"

namespace cromer::core {

/// Least and greatest value.
struct Extremes {
  double low, high;

  double magnitude() const { return std::max(-low, high); }
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// The motion through y at the beginning of an interval, under the force f + slope t; its derivatives there.
struct IntervalMotion {
  State<double> y;
  double f, slope;            // [m/s^2], [m/s^3]
  double acceleration, jerk;  // [m/s^2], [m/s^3] just after the beginning

  IntervalMotion(const LinearLaw<double>& law, const State<double>& start, double force, double force_slope)
      : y(start),
        f(force),
        slope(force_slope),
        acceleration(force - 2 * law.decay_rate * start.v - law.stiffness * start.x),
        jerk(force_slope - 2 * law.decay_rate * acceleration - law.stiffness * start.v) {}
};

/// How far |q| may exceed both its end values inside an interval h. Under a ramp the acceleration of the
/// motion swings freely, and so does q'': its energy only falls, |q''| <= sqrt(q''(0)^2 + (q'''(0)/w)^2), and
/// a curve leaves its chord by at most h^2/8 of that.
inline double overshoot_bound(const LinearLaw<double>& law, const ResponseQuantity<double>& quantity,
                              const IntervalMotion& motion, double h) {
  const double snap = -2 * law.decay_rate * motion.jerk - law.stiffness * motion.acceleration;
  const double bend = quantity.x * motion.acceleration + quantity.v * motion.jerk;
  const double twist = quantity.x * motion.jerk + quantity.v * snap;
  return h * h / 8 * std::sqrt(bend * bend + twist * twist / law.stiffness);
}

/// Includes the extremes of q inside the interval, which ends with the motion at `end`; w h at most pi. Each
/// is found where q' vanishes, by Newton's iteration on the closed form, to rounding of q.
void include_inside(const LinearLaw<double>& law, const ResponseQuantity<double>& quantity,
                    const IntervalMotion& motion, const State<double>& end, double h, Extremes& range);

/// Includes the extremes of q of the free motion from y on, y included: the first two turns, beyond which it
/// only dies down, and 0, where it ends.
void include_free(const LinearLaw<double>& law, const ResponseQuantity<double>& quantity,
                  const State<double>& y, Extremes& range);

}  // namespace cromer::core
