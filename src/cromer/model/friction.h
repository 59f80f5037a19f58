// Dry friction (Coulomb): a motion in phases, each of them smooth.
//
// While the mass slides the friction is a constant force against the velocity. At rest it balances whatever
// pulls, up to the static friction: the mass sticks until the pull exceeds it, then slides with the pull. The
// law is never the sign function of a small velocity, so nothing chatters and nothing needs smoothing;
// run/stick_slip.h joins the phases where the velocity vanishes. C. A. de Coulomb, Theorie des machines
// simples, 1785; J. P. Den Hartog, Trans. ASME 53, 107 (1931).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/base/dual.h"
#include "cromer/base/state.h"
#include "cromer/model/propagate.h"

namespace cromer::core {

/// A smooth system with a constant deceleration: the phase of a slide one way.
template <class S, class Real>
class Sliding {
 public:
  static constexpr bool depends_on_velocity = S::depends_on_velocity;

  /// friction [m/s^2], signed: positive slows a positive velocity.
  Sliding(const S& smooth, const Real& friction) : smooth_(smooth), friction_(friction) {}

  /// [m/s^2]
  template <class Time, class T>
  T acceleration(const Time& t, const T& x, const T& v) const {
    return smooth_.acceleration(t, x, v) - T(friction_);
  }

  /// [m/s^2] Rounding error of the acceleration. Where the mass breaks loose, pull and friction cancel to
  /// it.
  double acceleration_rounding([[maybe_unused]] double t) const {
    double rounding = std::numeric_limits<double>::epsilon() * std::abs(value_of(friction_));
    if constexpr (requires { smooth_.acceleration_rounding(t); })
      rounding += smooth_.acceleration_rounding(t);
    return rounding;
  }

  /// The linear law without a drive: an arc about the place where spring and friction balance.
  State<Real> propagate(const Real& t0, const Real& t, const State<Real>& y0) const requires
      requires(const S& smooth) {
    smooth.free_law();
  }
  {
    LinearLaw<Real> law = smooth_.free_law();
    law.drive_amplitude = -friction_;
    return cromer::core::propagate(law, t0, t, y0);
  }

  /// From one zero of the velocity to the next [s]: half a period; infinite where the motion does not swing.
  double zero_spacing() const requires requires(const S& smooth) { smooth.free_law(); }
  {
    return cromer::core::zero_spacing({.decay_rate = value_of(smooth_.free_law().decay_rate),
                                       .stiffness = value_of(smooth_.free_law().stiffness)});
  }

 private:
  S smooth_;
  Real friction_;
};

/// A smooth system with dry friction, per unit mass [m/s^2]: kinetic >= 0 while it moves, up to holding >=
/// kinetic at rest.
template <class S, class Real>
class DryFriction {
 public:
  static constexpr bool depends_on_velocity = true;
  static constexpr bool depends_on_time = S::depends_on_time;

  DryFriction(const S& smooth, const Real& kinetic, const Real& holding)
      : smooth_(smooth), kinetic_(kinetic), holding_(std::max(kinetic, holding)) {}

  /// [m/s^2] At rest 0 if the mass sticks. It jumps, so that methods integrate the phases below instead.
  template <class Time, class T>
  T acceleration(const Time& t, const T& x, const T& v) const {
    const T smooth = smooth_.acceleration(t, x, v);
    if (!(v == T(0))) return smooth - T(kinetic_) * sgn(v);
    return smooth <= T(holding_) && -smooth <= T(holding_) ? T(0) : smooth - T(kinetic_) * sgn(smooth);
  }

  /// The phase of a slide with velocities of this sign, 1 or -1.
  Sliding<S, Real> sliding(int direction) const { return {smooth_, direction > 0 ? kinetic_ : -kinetic_}; }

  /// What friction must balance to hold the mass at x [m/s^2].
  Real pull(double t, const Real& x) const { return smooth_.acceleration(t, x, Real(0)); }

  /// The first time after t [s] at which the smooth system's drive is not smooth.
  double next_break(double t) const requires(requires(const S& s) { s.next_break(0.0); }) {
    return smooth_.next_break(t);
  }

  /// The same with the piece of the drive that holds at t, extended to all times.
  DryFriction within(double t) const requires(requires(const S& s) { s.within(0.0); }) {
    DryFriction same = *this;
    same.smooth_ = smooth_.within(t);
    return same;
  }

  /// The first time after t at which the pull on a mass at rest may turn or jump [s]: until then it only
  /// rises or only falls.
  double next_turn(double t) const requires(depends_on_time) { return smooth_.next_turn(t); }

  /// The largest pull that friction balances at rest [m/s^2].
  Real holding() const { return holding_; }

 private:
  S smooth_;
  Real kinetic_, holding_;
};

}  // namespace cromer::core
