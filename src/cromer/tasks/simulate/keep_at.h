// A run's states at the times of a recording.
#pragma once

#include <utility>
#include <vector>

#include "cromer/base/state.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// Takes the states of a run at the times `t` [s], strictly increasing, which must outlive it; between two
/// states by the cubic that has their positions and velocities, within `slack` [s] of one that state.
class KeepAt {
 public:
  KeepAt(const std::vector<double>& t, double slack) : t_(t), slack_(slack) {
    kept_.t.reserve(t.size());
    kept_.x.reserve(t.size());
    kept_.v.reserve(t.size());
  }

  void operator()(double t, const State<double>& y) {
    while (kept_.size() < t_.size() && t_[kept_.size()] <= t + slack_) {
      const double at = t_[kept_.size()];
      const State<double> here = t - at <= slack_ ? y : between(at, t, y);
      kept_.t.push_back(at);
      kept_.x.push_back(here.x);
      kept_.v.push_back(here.v);
    }
    before_t_ = t;
    before_ = y;
  }

  Trajectory take() { return std::move(kept_); }

 private:
  State<double> between(double at, double t, const State<double>& y) const {
    const double h = t - before_t_, s = (at - before_t_) / h;
    const double dx = y.x - before_.x;
    const double a = h * before_.v, b = h * y.v;
    const double c2 = 3 * dx - 2 * a - b, c3 = a + b - 2 * dx;
    return {before_.x + s * (a + s * (c2 + s * c3)), (a + s * (2 * c2 + 3 * s * c3)) / h};
  }

  const std::vector<double>& t_;
  double slack_;
  double before_t_ = 0;
  State<double> before_{};
  Trajectory kept_;
};

}  // namespace cromer::core
