// The energy balance of the exact motion with dry friction: arc by arc.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

#include "cromer/analysis/energy_balance.h"
#include "cromer/analysis/exact_energy_balance.h"
#include "cromer/base/state.h"
#include "cromer/methods/exact.h"
#include "cromer/model/linear_quantities.h"
#include "cromer/model/oscillator.h"
#include "cromer/model/propagate.h"
#include "cromer/run/course.h"
#include "cromer/run/fixed_steps.h"
#include "cromer/run/keep.h"
#include "cromer/run/stick_slip.h"

namespace cromer::core {

/// Integral of v^2 [m^2/s] over the arc of a sliding mass from y0 at `from` to `until`, to rounding. The
/// panels begin as short as the fastest decay and double, up to a quarter of a period where there is one:
/// what dies out at the start is seen however long the arc is.
template <class Arc>
double square_over_arc(const Arc& arc, const LinearLaw<double>& law, const State<double>& y0, double from,
                       double until) {
  const double b = law.decay_rate, s = law.stiffness;
  constexpr double any = std::numeric_limits<double>::infinity();
  const double longest = s > b * b ? std::numbers::pi / 2 / std::sqrt(s) : any;
  const double shortest = std::min(longest, 1 / (2 * b + std::sqrt(std::abs(s))));
  const auto power = [&](double u) { return power_of(0, arc.propagate(0, u, y0)); };
  double sum = 0;
  for (double begin = 0, end = 0; begin < until - from; begin = end) {
    end = std::min(until - from, begin + std::clamp(begin, shortest, longest));
    const Power whole = gauss_panel(power, begin, end);
    long long budget = 1000;
    Power enough{.drive = any};
    enough.taken.of<Viscous>() = 2e-15 * whole.taken.of<Viscous>();
    enough.taken.of<Friction>() = any;
    sum += halved(power, begin, end, whole, enough, budget).taken.template of<Viscous>();
  }
  return sum;
}

/// The balance from 0 to `until` [s] of the exact motion of an oscillator with dry friction and without
/// drive, drag and cubic stiffness; `system` is its DryFriction. Friction takes its force times the path from
/// stop to stop, damping what it takes along each arc's closed form; at rest nothing is taken. Closes to
/// 1e-14 of the energy at the start, or to 1e-16 of it for each arc where there are many.
template <FrictionSystem S>
requires(ExactSystem<SlidingSystem<S>, double>) EnergyBalance
    exact_friction_balance(const S& system, const Oscillator<double>& oscillator, const State<double>& start,
                           double until) {
  const LinearLaw<double> law = linear_law(oscillator);
  const Rows rows{{0, until}, until};
  Course<double> course{0, start};
  KeepNone keep_none;
  Power work{};
  const Exact exact;
  const auto slide = [&](int direction) {
    const auto arc = system.sliding(direction);
    const double from = course.t;
    const State<double> y0 = course.y;
    StepperOf stepper(arc, exact, from, y0);
    take_fixed_steps(stepper, rows, {direction, nullptr}, course, keep_none, {}, {});
    work.taken.of<Friction>() += std::abs(course.y.x - y0.x);
    if (law.decay_rate > 0) work.taken.of<Viscous>() += square_over_arc(arc, law, y0, from, course.t);
  };
  stick_and_slip(system, rows, course, slide, keep_none, {});
  return energy_balance(oscillator, start, course.y, work);
}

}  // namespace cromer::core
