#include "cromer/identify/motion/integrate_through.h"

namespace cromer::core {
namespace {

using FreeUnit = MotionUnit<free_laws, FreeColumns>;

}  // namespace

const MotionFunctions free_motions = FreeUnit::functions();

Rest rest_of(const FittedParameters& fitted, const Parameters& parameters, const Record& record, double h) {
  Rest rest;
  int direction = 0;
  FreeUnit::gradients(fitted, parameters, {}, record.t, 0, h,
                      [&](std::size_t i, int now, double x, const Parameters& gradient) {
                        if (now != 0) {
                          rest.half_swings += now != direction;
                          rest.first = i + 1;
                        } else if (rest.first == i) {
                          rest.position = x;
                          rest.derivative = gradient;
                        }
                        direction = now;
                      });
  return rest;
}

VelocityGradient velocity_gradient(const FittedParameters& fitted, const Motion& motion, double duration,
                                   double h) {
  VelocityGradient result{motion.velocity, {}};
  if (duration <= 0) {
    if (const int velocity = fitted.place_of("velocity"); velocity >= 0) result.derivative[velocity] = 1;
    return result;
  }
  const double times[] = {0, duration};
  FreeUnit::gradients(fitted, fitted.pack(motion), {}, times, 1, h,
                      [&](std::size_t, int, double v, const Parameters& gradient) {
                        result = {v, gradient};
                      });
  return result;
}

}  // namespace cromer::core
