// A system made ready for the times at which a method will ask.
#pragma once

#include <utility>

namespace cromer::core {

/// A system for steps of any length, one after another: its own form that is ready at the method's nodes, if
/// system and method have that, else the system itself.
template <class S, class M>
class ReadyForSteps {
 public:
  explicit ReadyForSteps(const S& system) : system_(system) {}
  const S& over(double, double) { return system_; }

 private:
  const S& system_;
};

template <class S, class M>
requires requires(const S& system) { system.template on_nodes<M>().move_to(0.0, 1.0); }
class ReadyForSteps<S, M> {
 public:
  explicit ReadyForSteps(const S& system) : ready_(system.template on_nodes<M>()) {}

  /// For the step from t to t + h [s].
  const auto& over(double t, double h) {
    ready_.move_to(t, h);
    return ready_;
  }

 private:
  decltype(std::declval<const S&>().template on_nodes<M>()) ready_;
};

}  // namespace cromer::core
