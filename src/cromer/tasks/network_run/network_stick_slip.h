// A run of a network with dry friction, phase by phase: in each one some contacts slide one way and the
// others stick. A phase ends where a sliding contact comes to rest or one that sticks cannot hold any more;
// these moments are found to rounding by the method's own partial steps, which keeps its order.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "cromer/base/function_ref.h"
#include "cromer/base/state.h"
#include "cromer/methods/method.h"
#include "cromer/model/network_friction.h"
#include "cromer/model/network_phase.h"
#include "cromer/model/network_system.h"
#include "cromer/run/adaptive_steps.h"
#include "cromer/run/course.h"
#include "cromer/run/event.h"
#include "cromer/run/fixed_steps.h"

namespace cromer::core {

using RecordMasses = FunctionRef<void(double t, const State<MassVector>& y)>;

/// Which contacts of a network slide, and what ends a phase.
class ContactPhases {
 public:
  explicit ContactPhases(const Network& network);

  /// Begins the phase that follows the state, whose velocities are made equal where masses stick together.
  void begin(double t, State<MassVector>& y);

  const NetworkPhase& phase() const { return *phase_; }
  /// What the method integrates in this phase.
  const NetworkSystem<>& system() const { return system_; }

  /// Every mass sticks to the ground: records rows until one breaks loose or the run ends. Pulls are looked
  /// at wherever a drive turns, on both sides.
  void rest(const Rows& rows, Course<MassVector>& course, const RecordMasses& record, const Watch& watch);

  /// Some contact that sticks cannot hold at this state.
  bool breaks_loose(double t, const State<MassVector>& y) const;

  const NetworkFriction& friction() const { return friction_; }
  /// 1 or -1 while a contact slides that way, 0 while it sticks.
  const std::vector<int>& directions() const { return directions_; }
  /// Contacts that stick for one step, whatever pulls.
  bool any_held() const { return any_held_; }

  /// The contact has come to rest; or it is not seen to move: then it sticks for a step.
  void stop(std::size_t contact) { directions_[contact] = 0; }
  void hold(std::size_t contact) { to_hold_.push_back(contact); }

 private:
  Network network_;
  NetworkFriction friction_;
  NetworkSystem<> smooth_, system_;
  std::shared_ptr<const NetworkPhase> phase_;
  std::vector<int> directions_;
  std::vector<bool> held_;
  std::vector<std::size_t> to_hold_;
  bool any_held_ = false;
  double last_begin_ = -1;  // [s]
  std::size_t begins_ = 0;  ///< there
};

/// What to look for in a step of a phase.
struct ContactLookout {
  using Number = MassVector;

  ContactPhases& phases;

  bool anything() const { return true; }
};

using MassStateInside = FunctionRef<State<MassVector>(double theta)>;

CutOf<MassVector> look_inside(const ContactLookout& look, double t, double h, const State<MassVector>& y0,
                              const State<MassVector>& y1, long long pieces, const MassStateInside& state_at,
                              const MassStateInside& exactly);

/// As solve, of a network with dry friction; not by a closed form.
template <class M, class Recorder>
Outcome solve_with_contacts(const Network& network, const M& method, Interval interval,
                            const State<MassVector>& start, StepControl control, Recorder& record,
                            const Watch& watch) {
  const Rows rows{interval, control.step};
  Course<MassVector> course{interval.from, start};
  MotionScale scale;
  const auto one_by_one = [&](double t, const State<MassVector>& y) { record(t, y); };
  ContactPhases phases(network);
  const ContactLookout look{phases};
  phases.begin(course.t, course.y);
  one_by_one(course.t, course.y);
  while (course.goes_on(rows)) {
    if (phases.phase().all_at_rest() && !phases.any_held()) {
      phases.rest(rows, course, one_by_one, watch);
    } else if constexpr (AdaptiveMethod<M, NetworkSystem<>, MassVector>) {
      take_adaptive_steps(phases.system(), method, rows, control, look, scale, course, one_by_one, watch,
                          Limits{});
    } else {
      StepperOf stepper(phases.system(), method, course.t, course.y);
      take_searched_steps(stepper, rows, look, course, one_by_one, watch, Limits{});
    }
    if (course.goes_on(rows)) phases.begin(course.t, course.y);
  }
  return course.outcome(rows, watch);
}

}  // namespace cromer::core
