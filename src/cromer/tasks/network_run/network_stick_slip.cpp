#include "cromer/tasks/network_run/network_stick_slip.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/run/root.h"

namespace cromer::core {
namespace {

/// The first place between two at which something is true, to rounding: false at `no`, true at `yes`.
double first_place(const FunctionRef<bool(double)>& is, double no, double yes) {
  for (;;) {
    const double middle = no + (yes - no) / 2;
    if (!(middle > no && middle < yes) || yes - no < std::numeric_limits<double>::epsilon() * 0.25)
      return yes;
    (is(middle) ? yes : no) = middle;
  }
}

}  // namespace

ContactPhases::ContactPhases(const Network& network)
    : network_(network),
      friction_(network),
      smooth_(network),
      system_(smooth_),
      directions_(friction_.contacts().size()),
      held_(directions_.size()) {
  const Vector v = start_of(network).v.first;
  for (std::size_t c = 0; c < directions_.size(); ++c) {
    const double speed = friction_.speed(c, v);
    directions_[c] = speed > 0 ? 1 : speed < 0 ? -1 : 0;
  }
}

void ContactPhases::begin(double t, State<MassVector>& y) {
  // Moments that follow each other in no time at all would do so for ever.
  const std::size_t contacts = directions_.size();
  begins_ = t == last_begin_ ? begins_ + 1 : 0;
  last_begin_ = t;
  if (begins_ > 2 * contacts + 2)
    for (std::size_t c = 0; c < contacts; ++c)
      if (directions_[c] == 0 || friction_.speed(c, y.v.first) * directions_[c] <= 0) hold(c);
  held_.assign(contacts, false);
  for (const std::size_t c : to_hold_) {
    held_[c] = true;
    directions_[c] = 0;
  }
  any_held_ = !to_hold_.empty();
  to_hold_.clear();

  // Where one contact stops, others may stop with it: those that close a loop of contacts.
  for (bool again = true; again;) {
    NetworkPhase(network_, friction_.contacts(), directions_).join(y.v.first);
    again = false;
    for (std::size_t c = 0; c < contacts; ++c)
      if (directions_[c] != 0 && !(directions_[c] * friction_.speed(c, y.v.first) > 0)) {
        directions_[c] = 0;
        again = true;
      }
  }
  friction_.decide(smooth_.acceleration(t, y.x, y.v).first, directions_, held_);
  phase_ = std::make_shared<NetworkPhase>(network_, friction_.contacts(), directions_);
  system_ = smooth_.in(phase_);
}

bool ContactPhases::breaks_loose(double t, const State<MassVector>& y) const {
  if (std::find(directions_.begin(), directions_.end(), 0) == directions_.end()) return false;
  std::vector<int> directions = directions_;
  friction_.decide(smooth_.acceleration(t, y.x, y.v).first, directions, held_);
  return directions != directions_;
}

void ContactPhases::rest(const Rows& rows, Course<MassVector>& course, const RecordMasses& record,
                         const Watch& watch) {
  course.at_rest = false;
  while (course.goes_on(rows)) {
    if (course.row % 1024 == 0 && watch.interrupted()) {
      course.interrupted = true;
      course.status = Status::stopped_by_event;
      return;
    }
    const double next = rows.time(course.row + 1);
    while (course.t < next) {
      const double from = course.t, turn = smooth_.next_turn(from);
      const double to = turn > from ? std::min(turn, next) : next;
      for (const double at : {std::nextafter(to, from), to})
        if (breaks_loose(at, course.y)) {
          const double span = at - from;
          const auto loose = [&](double share) { return breaks_loose(from + share * span, course.y); };
          course.t = from + first_place(loose, 0, 1) * span;
          return;
        }
      course.t = to;
    }
    course.t = next;
    ++course.row;
    record(course.t, course.y);
  }
}

CutOf<MassVector> look_inside(const ContactLookout& look, double t, double h, const State<MassVector>& y0,
                              const State<MassVector>& y1, long long pieces, const MassStateInside& state_at,
                              const MassStateInside& exactly) {
  ContactPhases& phases = look.phases;
  const NetworkFriction& friction = phases.friction();
  State<MassVector> start = y0;
  double from = 0;
  for (long long i = 1; i <= pieces; ++i) {
    double to = static_cast<double>(i) / static_cast<double>(pieces);
    State<MassVector> end = i < pieces ? state_at(to) : y1;
    std::size_t stopped = friction.contacts().size();
    for (std::size_t c = 0; c < friction.contacts().size(); ++c) {
      const int direction = phases.directions()[c];
      const auto forwards = [&](const State<MassVector>& y) {
        return direction * friction.speed(c, y.v.first);
      };
      if (direction == 0 || forwards(end) > 0) continue;
      // It slid and stopped; or it began to slide in this part and stopped again; or the pull just balances
      // the friction and only rounding moves it: then it sticks for a step.
      double moving_at = from, moving = forwards(start);
      for (double share = 0.5; !(moving > 0) && share > 1e-9; share /= 4) {  // in the first part alone
        moving_at = to * share;
        moving = forwards(exactly(moving_at));
      }
      if (!(moving > 0)) {
        phases.hold(c);
        return {.theta = 0, .y = y0, .at_rest = true};
      }
      to = find_root([&](double theta) { return forwards(exactly(theta)); }, moving_at, moving, to,
                     forwards(exactly(to)));
      end = exactly(to);
      stopped = c;
    }
    // One that sticks may break loose first.
    if (phases.breaks_loose(t + to * h, end)) {
      const auto loose = [&](double share) {
        const double theta = from + share * (to - from);
        return phases.breaks_loose(t + theta * h, exactly(theta));
      };
      const double share = loose(1) ? first_place(loose, 0, 1) : 1;
      if (share < 1) {
        const double theta = from + share * (to - from);
        return {.theta = theta, .y = exactly(theta), .at_rest = true};
      }
      if (stopped == friction.contacts().size()) return {.theta = to, .y = end, .at_rest = true};
    }
    if (stopped < friction.contacts().size()) {
      phases.stop(stopped);
      return {.theta = to, .y = end, .at_rest = true};
    }
    from = to;
    start = end;
  }
  return {.theta = 1, .y = y1, .at_rest = phases.any_held()};
}

}  // namespace cromer::core
