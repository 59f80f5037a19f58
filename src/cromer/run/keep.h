// What to save of a run: recorders, called with every state.
#pragma once

#include <cstddef>
#include <utility>

#include "cromer/base/state.h"
#include "cromer/run/steps.h"
#include "cromer/run/trajectory.h"

namespace cromer {

/// Keeps the first and every Nth state after it. Memory is taken once, at the start; check
/// number_of_kept_states before.
class KeepEvery {
 public:
  /// every > 0
  KeepEvery(long long every, Steps steps) : every_(every) {
    const auto size = static_cast<std::size_t>(number_of_kept_states(steps, every));
    kept_.t.resize(size);
    kept_.x.resize(size);
    kept_.v.resize(size);
  }

  void operator()(double t, const State<double>& y) {
    if (--until_next_ > 0) return;
    until_next_ = every_;
    kept_.t[size_] = t;
    kept_.x[size_] = y.x;
    kept_.v[size_] = y.v;
    ++size_;
  }

  /// Forgets the states but keeps the memory, for the next run of as many steps.
  void clear() {
    size_ = 0;
    until_next_ = 1;
  }

  /// The states so far; the recorder is then empty.
  Trajectory take() {
    kept_.t.resize(size_);
    kept_.x.resize(size_);
    kept_.v.resize(size_);
    size_ = 0;
    return std::move(kept_);
  }

 private:
  long long every_, until_next_ = 1;
  std::size_t size_ = 0;
  Trajectory kept_;
};

/// Keeps nothing: the outcome has the final state.
struct KeepNone {
  template <class Real>
  void operator()(double, const State<Real>&) {}
};

}  // namespace cromer
