// The energy balance of a motion that is known at every time.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "cromer/analysis/energy_balance.h"
#include "cromer/base/state.h"
#include "cromer/model/oscillator.h"

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

/// Integral of power(t) over a panel, halved until both halves together say the same: kinks and jumps are
/// closed in on. `budget` bounds the halvings, which rounding could keep going.
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

/// What the balance of an exact motion is an integral of, from `from` to `until` [s], where the force is
/// smooth: state(t) gives the motion at any time, force(t) the drive's force [N]. panel [s] > 0: a quarter of
/// the shortest period, or less.
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

/// The balance of an exact motion from 0 to `until` [s]; the oscillator has no drag. Closes to about 1e-14 of
/// the largest of its terms; kinks and jumps of the force, if not many, are closed in on.
template <class F, class Motion>
EnergyBalance exact_energy_balance(const F& force, const Oscillator<double>& oscillator, const Motion& state,
                                   double until, double panel) {
  return energy_balance(oscillator, state(0.0), state(until), exact_work(force, state, 0, until, panel));
}

}  // namespace cromer::core
