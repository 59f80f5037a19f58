// What model and methods share: the state of one oscillator and what a method may ask of the system it
// integrates.
#pragma once

#include <concepts>

#include "cromer/trajectory.h"

namespace cromer::core {

/// Something with an acceleration [m/s^2] at a time [s], position [m] and velocity [m/s].
template <class S, class Real>
concept System = requires(const S& system, Real t, Real x, Real v) {
  { system.acceleration(t, x, v) } -> std::convertible_to<Real>;
};

/// A System whose motion has a closed form: propagate(t0, t, y0) is the state at t of the motion through y0
/// at t0.
template <class S, class Real>
concept ExactSystem = System<S, Real> && requires(const S& system, Real t0, Real t, State<Real> y0) {
  { system.propagate(t0, t, y0) } -> std::convertible_to<State<Real>>;
};

}  // namespace cromer::core
