// What happens inside a step: events, and the moment a sliding mass comes to rest.
#pragma once

#include "cromer/base/function_ref.h"
#include "cromer/base/state.h"
#include "cromer/run/event.h"

namespace cromer::core {

/// What to look for.
struct Lookout {
  int direction = 0;           ///< sign of the velocity while the mass slides; 0 without dry friction
  EventLog* events = nullptr;  ///< nullptr or empty: none

  bool anything() const { return direction != 0 || (events && !events->events.empty()); }
};

/// How far a step is good.
struct Cut {
  double theta = 1;  ///< of the step
  State<double> y{};
  bool at_rest = false;  ///< the sliding mass stopped there
  bool stopped = false;  ///< an event ends the run there
};

/// The state at a fraction of a step, 0 to 1. Seldom asked for: only where something happens.
using StateInside = FunctionRef<State<double>(double theta)>;

/// Looks through the step from y0 at t to y1 at t + h in `pieces` equal parts. state_at(theta) is the state
/// inside the step; exactly(theta) is what a step of just that length gives, for the moment of rest: from
/// there the motion goes on.
Cut look_inside(const Lookout& look, double t, double h, const State<double>& y0, const State<double>& y1,
                long long pieces, StateInside state_at, StateInside exactly);

}  // namespace cromer::core
