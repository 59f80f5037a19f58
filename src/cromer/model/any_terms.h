// The law with its terms told at run time: one type for all laws, for where code must be small.
//
// Absent terms are stepped over, so that accelerations are those of the DrivenOscillator that has exactly the
// terms present, to the bit (of a zero the sign may differ).
#pragma once

#include <cmath>
#include <limits>

#include "cromer/base/dual.h"
#include "cromer/base/state.h"
#include "cromer/model/harmonic_force.h"
#include "cromer/model/law_force.h"
#include "cromer/model/oscillator.h"
#include "cromer/model/propagate.h"

namespace cromer::core {

/// Smooth, or sliding one way with dry friction.
class AnyTerms {
 public:
  /// Oscillator and force per unit mass. The oscillator's friction is ignored.
  AnyTerms(const Oscillator<double>& per_mass, const HarmonicForce<double>& force)
      : law_(per_mass), present_(law_of(per_mass).without(law_with<Friction>)), force_(force) {}

  /// The same, slowed by a constant friction [m/s^2]; positive slows a positive velocity.
  AnyTerms sliding(double friction) const {
    AnyTerms same = *this;
    same.friction_ = friction;
    return same;
  }

  /// The force depends on the velocity.
  bool resists() const { return present_.shares(terms_of_velocity); }
  bool driven() const { return force_.amplitude != 0; }
  bool linear() const { return is_linear(present_); }

  /// [m/s^2]. T is double, or a Dual over it.
  template <class T>
  T acceleration(double t, const T& x, const T& v) const {
    T a(0.0);
    if (driven()) a = T(table_ ? (*table_)(t) : force_(t));
    if (resists()) a = a - resisting_force<any_terms>(law_, present_, x, v);
    a = a - restoring_force<any_terms>(law_, present_, x);
    if (friction_ != 0) a = a - T(friction_);
    return a;
  }

  /// [m/s^2] Rounding error of the acceleration. Where a mass breaks loose, pull and friction cancel to it.
  double acceleration_rounding(double) const {
    return std::numeric_limits<double>::epsilon() * std::abs(friction_);
  }

  /// The state at t of the motion through y0 at t0; of a linear law, driven or with friction but not both.
  State<double> propagate(double t0, double t, const State<double>& y0) const {
    const LinearLaw<double> law{.decay_rate = law_.damping / 2, .stiffness = law_.stiffness};
    const HarmonicForce<double> force = driven() ? force_ : HarmonicForce<double>{-friction_, 0, 0};
    return force.propagate(law, t0, t, y0);
  }

  /// From one zero of the velocity to the next [s], of a linear law without a drive; else infinite.
  double zero_spacing() const {
    if (!linear() || driven()) return std::numeric_limits<double>::infinity();
    return cromer::core::zero_spacing({.decay_rate = law_.damping / 2, .stiffness = law_.stiffness});
  }

  /// The first time after t at which the drive turns; infinite without one.
  double next_turn(double t) const {
    return driven() ? force_.next_turn(t) : std::numeric_limits<double>::infinity();
  }

  const HarmonicForce<double>& force() const { return force_; }

  /// Looks the drive up in this table from now on, which must be ready for the times asked; nullptr:
  /// computes it.
  void look_up_drive(const TabulatedForce<double>* table) { table_ = table; }

 private:
  Oscillator<double> law_;  // per unit mass; its mass is not used
  Law present_;
  HarmonicForce<double> force_;
  double friction_ = 0;  // [m/s^2]
  const TabulatedForce<double>* table_ = nullptr;
};

/// The law with dry friction per unit mass [m/s^2]: see DryFriction.
class AnyFriction {
 public:
  static constexpr bool depends_on_time = true;

  AnyFriction(const AnyTerms& smooth, double kinetic, double holding)
      : smooth_(smooth), kinetic_(kinetic), holding_(std::fmax(kinetic, holding)) {}

  AnyTerms sliding(int direction) const { return smooth_.sliding(direction > 0 ? kinetic_ : -kinetic_); }
  double pull(double t, double x) const { return smooth_.acceleration(t, x, 0.0); }
  double next_turn(double t) const { return smooth_.next_turn(t); }
  double holding() const { return holding_; }

 private:
  AnyTerms smooth_;
  double kinetic_, holding_;
};

}  // namespace cromer::core
