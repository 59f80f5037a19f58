// Recording 2 of the spring lab: a disc in air, from the equation of motion by rk4 at 1 ms and a sensor's
// noise and rounding.
#pragma once

#include <cmath>
#include <random>

#include "cromer/methods/rk4.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

inline constexpr Oscillator<double> disc_oscillator{
    .mass = 0.2176, .stiffness = 17.04, .damping = 0.000789, .drag = 0.02043};

inline Series disc_recording(unsigned seed = 2, double duration = 120,
                             const Oscillator<double>& oscillator = disc_oscillator) {
  Series series;
  series.column = "Position (m)";
  series.quantity = "position";
  series.unit = "m";
  series.time_column = "Time (s)";
  series.rate = 100;
  series.resolution = 1e-4;
  KeepEvery keep(10, count_steps({0, duration}, 1e-3));
  with_terms(oscillator, HarmonicDrive<double>{}, [&](const auto& system) {
    return solve(system, Rk4{}, Interval{0, duration}, State<double>{0.036, 0}, 1e-3, keep);
  });
  const Trajectory motion = keep.take();
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0, 3e-4);
  series.t = motion.t;
  for (double x : motion.x) series.y.push_back(1e-4 * std::round((0.2 + x + normal(engine)) / 1e-4));
  series.lines.resize(series.t.size());
  return series;
}

}  // namespace cromer::core
