// What happens inside a step: events, the moments a motion passes a position or a velocity, and the moment
// a sliding mass comes to rest.
#pragma once

#include <cstddef>
#include <vector>

#include "cromer/base/function_ref.h"
#include "cromer/base/state.h"

namespace cromer::core {

enum class Crossing { any, rising, falling };

/// A threshold to watch for. A turning point is velocity = 0.
struct Event {
  enum class Quantity { position, velocity };

  Quantity quantity = Quantity::velocity;
  double value = 0;  // [m] or [m/s]
  Crossing crossing = Crossing::any;
  bool stop = false;  ///< the run ends there

  /// Quantity minus value; the event is where it changes its sign.
  double distance(const State<double>& y) const {
    return (quantity == Quantity::position ? y.x : y.v) - value;
  }

  /// Whether going from one distance to another passes the event. A motion that starts on the threshold has
  /// not passed it; one that arrives there has.
  bool passed(double from, double to) const {
    if (from == 0 || !(to == 0 || (from > 0) != (to > 0))) return false;
    return crossing == Crossing::any || (crossing == Crossing::rising) == (from < 0);
  }
};

/// One that happened.
struct FoundEvent {
  std::size_t event = 0;  ///< index into those watched for
  double t = 0;           // [s]
  State<double> y{};
};

/// The events to watch for, and those found, in order of time.
struct EventLog {
  static constexpr long long most = 1'000'000;  ///< found events that are kept; others are only counted

  std::vector<Event> events{};
  std::vector<FoundEvent> found{};
  long long missed = 0;  ///< found beyond `most`

  void add(const FoundEvent& one) {
    if (static_cast<long long>(found.size()) < most)
      found.push_back(one);
    else
      ++missed;
  }
};

/// What to look for in a motion of one number.
struct Lookout {
  using Number = double;

  int direction = 0;           ///< sign of the velocity while the mass slides; 0 without dry friction
  EventLog* events = nullptr;  ///< nullptr or empty: none

  bool anything() const { return direction != 0 || (events && !events->events.empty()); }
};

/// How much of a step is kept.
template <class Real>
struct CutOf {
  double theta = 1;  ///< fraction of the step
  State<Real> y{};
  bool at_rest = false;  ///< the phase ends there: the sliding mass stopped
  bool stopped = false;  ///< an event ends the run there
};
using Cut = CutOf<double>;

/// The state at a fraction of a step, 0 to 1. Asked for seldom, only where something happens.
using StateInside = FunctionRef<State<double>(double theta)>;

/// Looks through the step from y0 at t to y1 at t + h in `pieces` equal parts. state_at(theta) is the state
/// inside the step; exactly(theta) is what a step of just that length gives, for the moment of rest: from
/// there the motion goes on.
Cut look_inside(const Lookout& look, double t, double h, const State<double>& y0, const State<double>& y1,
                long long pieces, StateInside state_at, StateInside exactly);

}  // namespace cromer::core
