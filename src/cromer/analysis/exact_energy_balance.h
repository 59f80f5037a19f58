// The energy balance of a motion that is known at every time, by quadrature; with dry friction, arc by arc.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "cromer/analysis/energy_balance.h"
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

/// One ten-point Gauss-Legendre panel: exact for polynomials of degree 19.
template <class F>
Power gauss_panel(const F& power, double a, double b) {
  constexpr std::array<double, 5> nodes{0.14887433898163121089, 0.43339539412924719080,
                                        0.67940956829902440623, 0.86506336668898451073,
                                        0.97390652851717172008};
  constexpr std::array<double, 5> weights{0.29552422471475287017, 0.26926671930999635509,
                                          0.21908636251598204400, 0.14945134915058059315,
                                          0.06667134430868813759};
  const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
  Power sum{};
  for (std::size_t i = 0; i < nodes.size(); ++i)
    sum = sum + weights[i] * (power(middle - half * nodes[i]) + power(middle + half * nodes[i]));
  return half * sum;
}

/// Integral of power(t) over a panel, which is halved until the halves agree with the whole: this closes in
/// on kinks and jumps. `budget` bounds the number of halvings, which rounding could keep going.
template <class F>
Power halved(const F& power, double a, double b, const Power& whole, const Power& enough, long long& budget) {
  const double middle = 0.5 * (a + b);
  const Power left = gauss_panel(power, a, middle), right = gauss_panel(power, middle, b);
  const Power both = left + right, off = both - whole;
  const auto small = [&]<class T>() { return std::abs(off.taken.of<T>()) <= enough.taken.of<T>(); };
  const bool agrees = std::abs(off.drive) <= enough.drive && small.template operator()<Viscous>() &&
                      small.template operator()<Friction>();
  if (agrees || !(a < middle && middle < b) || --budget < 0) return both;
  return halved(power, a, middle, left, enough, budget) + halved(power, middle, b, right, enough, budget);
}

/// The integrals of the balance of an exact motion from `from` to `until` [s], where the force is smooth.
/// state(t) gives the motion at any time, force(t) the drive's force [N]. panel [s] > 0: a quarter of the
/// shortest period, or less.
template <class F, class Motion>
Power exact_work(const F& force, const Motion& state, double from, double until, double panel) {
  const auto power = [&](double t) { return power_of(force(t), state(t)); };
  const auto panels = static_cast<long long>(std::ceil((until - from) / panel));
  const auto edge = [&](long long i) {
    return from + (until - from) * (static_cast<double>(i) / static_cast<double>(panels));
  };
  Power size{};
  for (long long i = 0; i < panels; ++i) {
    Power part = gauss_panel(power, edge(i), edge(i + 1));
    part.drive = std::abs(part.drive);
    size = size + part;
  }
  // A few roundings of the whole: less is noise, whatever the panel.
  const Power enough = 2e-15 * size;
  long long budget = 64 * panels + 10'000;
  Power work{};
  for (long long i = 0; i < panels; ++i)
    work =
        work + halved(power, edge(i), edge(i + 1), gauss_panel(power, edge(i), edge(i + 1)), enough, budget);
  return work;
}

/// The balance of an exact motion from 0 to `until` [s]; the oscillator has no drag. Closes to about 1e-14
/// of the largest of its terms, also over kinks and jumps of the force if they are few.
template <class F, class Motion>
EnergyBalance exact_energy_balance(const F& force, const Oscillator<double>& oscillator, const Motion& state,
                                   double until, double panel) {
  return energy_balance(oscillator, state(0.0), state(until), exact_work(force, state, 0, until, panel));
}

/// Integral of v^2 [m^2/s] over the arc of a sliding mass from y0 at `from` to `until`, to rounding. The
/// panels begin as short as the fastest decay and double, up to a quarter of a period where there is one:
/// what dies out at the start is seen however long the arc is.
template <class Arc>
double square_over_arc(const Arc& arc, const LinearLaw<double>& law, const State<double>& y0, double from,
                       double until) {
  const double b = law.decay_rate, s = law.stiffness;
  constexpr double any = std::numeric_limits<double>::infinity();
  const double longest = s > b * b ? std::numbers::pi / 2 / std::sqrt(s) : any;
  const double shortest = std::min(longest, 1 / (2 * std::abs(b) + std::sqrt(std::abs(s))));
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
    if (law.decay_rate != 0) work.taken.of<Viscous>() += square_over_arc(arc, law, y0, from, course.t);
  };
  stick_and_slip(system, rows, course, slide, keep_none, {});
  return energy_balance(oscillator, start, course.y, work);
}

}  // namespace cromer::core
