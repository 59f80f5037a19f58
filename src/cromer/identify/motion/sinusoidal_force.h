// A harmonic drive at the stages of a method.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "cromer/identify/least_squares/normal_equations.h"

namespace cromer {

/// C cos(w s) + S sin(w s) per unit mass, s from the motion's first sample.
class SinusoidalForce {
 public:
  static constexpr int parameters = 3;
  static constexpr int cosine = 0, sine = 1, frequency = 2;

  /// `w` [rad/s].
  explicit SinusoidalForce(double w) : w_(w) {}

  /// Makes the interval that begins at s = t [s] and lasts dt ready, cut into `steps`.
  void prepare(std::size_t, double t, double dt, int steps) {
    begin_ = t;
    nodes_ = 2 * steps;
    per_node_ = nodes_ / dt;
    node_.resize(static_cast<std::size_t>(nodes_) + 1);
    // Turned from node to node: a few turns lose no digits.
    Node now{std::cos(w_ * t), std::sin(w_ * t)};
    const Node turn{std::cos(w_ / per_node_), std::sin(w_ / per_node_)};
    for (Node& node : node_) {
      node = now;
      now = {now.c * turn.c - now.s * turn.s, now.c * turn.s + now.s * turn.c};
    }
  }

  void add_to(const Parameters& p, double t, double& acceleration, double* by_parameter) const {
    const Node& n = node_[static_cast<std::size_t>((t - begin_) * per_node_ + 0.5)];
    acceleration += p[cosine] * n.c + p[sine] * n.s;
    if (!by_parameter) return;
    by_parameter[cosine] = n.c;
    by_parameter[sine] = n.s;
    by_parameter[frequency] = t * (p[sine] * n.c - p[cosine] * n.s);
  }

 private:
  struct Node {
    double c, s;
  };
  double w_, begin_ = 0, per_node_ = 1;
  int nodes_ = 2;
  std::vector<Node> node_;
};

}  // namespace cromer
