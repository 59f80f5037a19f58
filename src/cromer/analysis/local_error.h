// What a method leaves out in one step, measured against the exact flow.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "cromer/analysis/line.h"
#include "cromer/base/state.h"
#include "cromer/methods/method.h"

namespace cromer::core {

/// Errors of a single step from one state, for each step size; an order p method has slopes of p + 1.
struct LocalError {
  std::vector<double> step;      // [s]
  std::vector<double> position;  // [m] method minus exact
  std::vector<double> velocity;  // [m/s] method minus exact
  double position_slope = 0;     ///< of log |error| against log step
  double velocity_slope = 0;
};

/// One step of the method from y at t for each of `steps` (> 0, at least two different ones), against
/// system.propagate. In the asymptotic range: w h << 1, but errors still far above rounding. An error of
/// exactly 0 leaves the slope not finite.
template <class S, class M>
requires Method<M, S, double> && ExactSystem<S, double> LocalError local_error(
    const S& system, const M& method, double t, const State<double>& y, std::span<const double> steps) {
  LocalError result;
  std::vector<double> log_step, log_position, log_velocity;
  for (const double h : steps) {
    auto memory = method.start(system, t, y);
    const State<double> stepped = method.step(system, t, h, y, memory).y;
    const State<double> exact = system.propagate(t, t + h, y);
    result.step.push_back(h);
    result.position.push_back(stepped.x - exact.x);
    result.velocity.push_back(stepped.v - exact.v);
    log_step.push_back(std::log(h));
    log_position.push_back(std::log(std::abs(result.position.back())));
    log_velocity.push_back(std::log(std::abs(result.velocity.back())));
  }
  result.position_slope = fit_line(log_step, log_position).slope;
  result.velocity_slope = fit_line(log_step, log_velocity).slope;
  return result;
}

}  // namespace cromer::core
