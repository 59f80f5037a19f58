// The turning points of a sampled motion: its envelope above and below.
#pragma once

#include <span>
#include <vector>

namespace cromer::core {

/// Turning points, each the vertex of the parabola through the largest (smallest) sample and its neighbours.
/// With a period of n samples the vertex is low by about (pi/n)^4/6 of the amplitude at most.
struct Envelope {
  std::vector<double> top_t;     // [s]
  std::vector<double> top;       ///< in the unit of x
  std::vector<double> bottom_t;  // [s]
  std::vector<double> bottom;    ///< in the unit of x
};

/// `t` and `x` of the same length, `t` increasing. A first sample off zero at which the motion rests and
/// from which it falls back counts: it was released there.
Envelope envelope(std::span<const double> t, std::span<const double> x);

/// The value of an envelope at time `t` by linear interpolation; held beyond its ends. `at` and `values` of
/// the same length, not empty.
double interpolate(std::span<const double> at, std::span<const double> values, double t);

}  // namespace cromer::core
