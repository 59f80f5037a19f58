#include "cromer/run/event.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "cromer/run/root.h"

namespace cromer::core {
namespace {

/// A part of a step, from theta to theta.
struct Part {
  double from, to;
  State<double> start, end;
};

/// The theta between `from` and `to` at which a quantity turns, given its values at both; empty if it does
/// not. A turn within 1e-5 of the interval from an end changes the quantity by next to nothing, and does not
/// count.
template <class Quantity>
std::optional<double> turn_within(const Quantity& quantity, double from, double at_from, double to,
                                  double at_to) {
  const double near = 1e-5 * (to - from), first = from + near, last = to - near;
  const double before = quantity(first) - at_from, after = at_to - quantity(last);
  if (!(before * after < 0)) return std::nullopt;
  const auto rise = [&](double theta) { return quantity(theta + near) - quantity(theta - near); };
  return find_root(rise, first, before, last, after);
}

/// Adds the events within the part of the step from t to t + h to the log; returns where the first one that
/// stops is. Where the method's own path turns inside the part, the stretches before and after the turn are
/// searched separately: each passes a value at most once.
std::optional<double> log_events(EventLog& log, double t, double h, const Part& part, StateInside state_at) {
  std::vector<std::pair<double, std::size_t>> passed;
  for (std::size_t i = 0; i < log.events.size(); ++i) {
    const Event& event = log.events[i];
    const auto distance = [&](double theta) { return event.distance(state_at(theta)); };
    const auto look = [&](double from, double at_from, double to, double at_to) {
      if (event.passed(at_from, at_to)) passed.emplace_back(find_root(distance, from, at_from, to, at_to), i);
    };
    const double start = event.distance(part.start), end = event.distance(part.end);
    // With the ends on different sides a single turn changes nothing.
    const bool same_side = start == 0 || start * end > 0;
    if (const auto turn = same_side ? turn_within(distance, part.from, start, part.to, end) : std::nullopt) {
      const double there = distance(*turn);
      look(part.from, start, *turn, there);
      look(*turn, there, part.to, end);
    } else {
      look(part.from, start, part.to, end);
    }
  }
  std::sort(passed.begin(), passed.end());
  for (const auto& [theta, event] : passed) {
    log.add({event, t + theta * h, theta == part.to ? part.end : state_at(theta)});
    if (log.events[event].stop) return theta;
  }
  return std::nullopt;
}

}  // namespace

Cut look_inside(const Lookout& look, double t, double h, const State<double>& y0, const State<double>& y1,
                long long pieces, StateInside state_at, StateInside exactly) {
  const auto slides = [&](const State<double>& y) { return y.v * look.direction > 0; };
  Part part{0, 0, y0, y0};
  for (long long i = 1; i <= pieces; ++i) {
    part = {part.to, static_cast<double>(i) / static_cast<double>(pieces), part.end, y1};
    if (i < pieces) part.end = state_at(part.to);
    bool at_rest = false;
    if (look.direction != 0 && !slides(part.end)) {
      // Either it slid and stopped; or it began to slide in this part and stopped again; or the pull just
      // balances the friction and only rounding moves it: then it stays where it is for this step.
      double from = part.from;
      State<double> moving = part.start;
      for (double share = 0.5; !slides(moving) && share > 1e-9; share /= 4) {
        from = part.from + (part.to - part.from) * share;
        moving = exactly(from);
      }
      if (!slides(moving)) return {.theta = 1, .y = {part.start.x, 0}, .at_rest = true};
      part.to = find_root([&](double theta) { return exactly(theta).v; }, from, moving.v, part.to,
                          exactly(part.to).v);
      part.end = {exactly(part.to).x, 0};
      at_rest = true;
    }
    if (look.events)
      if (const auto stop = log_events(*look.events, t, h, part, state_at))
        return {.theta = *stop, .y = *stop == part.to ? part.end : state_at(*stop), .stopped = true};
    if (at_rest) return {.theta = part.to, .y = part.end, .at_rest = true};
  }
  return {.theta = 1, .y = y1};
}

}  // namespace cromer::core
