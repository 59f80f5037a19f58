// Oscillator and drive joined to what a method integrates: an acceleration.
//
//   return with_terms(oscillator, drive, [&](const auto& system) { return ...; });
//
// calls with the DrivenOscillator that has exactly the terms present, so that absent ones cost nothing in the
// loop; with friction it is a DryFriction around that.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "cromer/base/dual.h"
#include "cromer/base/state.h"
#include "cromer/model/any_terms.h"
#include "cromer/model/friction.h"
#include "cromer/model/harmonic_force.h"
#include "cromer/model/law_force.h"
#include "cromer/model/oscillator.h"
#include "cromer/model/propagate.h"

namespace cromer::core {

/// A force under which the linear law's motion is known: a member propagate(law, t0, t, y0), on the law
/// without a drive.
template <class Force, class Real>
concept HasClosedForm = requires(const Force& force, const LinearLaw<Real>& law, const Real& t,
                                 const State<Real>& y) {
  { force.propagate(law, t, t, y) } -> std::convertible_to<State<Real>>;
};

/// Takes the place of the run-time law where the law is known at compile time.
struct NoLaw {
  constexpr operator Law() const { return {}; }  // NOLINT: no terms
};

/// The law's smooth terms per unit mass: x'' = f(t) - the sum of their forces, each coefficient divided by m.
/// Force gives f(t) [m/s^2]: HarmonicForce, TabulatedForce after on_grid, NodeForce after on_nodes, or one
/// of general_drive.h.
template <class Real, Terms terms, class Force = HarmonicForce<Real>>
class DrivenOscillator {
 public:
  /// Oscillator and force per unit mass.
  DrivenOscillator(const Oscillator<Real>& per_mass, const Force& force) : law_(per_mass), force_(force) {
    if constexpr (terms.law == any_terms) present_ = law_of(per_mass);
  }

  /// The same with the terms that are present given by the caller: coefficients may then be packs of
  /// numbers.
  template <class Present>
  DrivenOscillator(const Coefficients<terms.law, Real>& per_mass, const Force& force, const Present& present)
      : law_(per_mass), force_(force), present_(present) {}

  static constexpr bool depends_on_velocity = has_resistance(terms.law);
  static constexpr bool depends_on_time = terms.drive;

  /// True of the form that on_nodes gives, for methods of many stages.
  static constexpr bool at_nodes = requires(Force & force) { force.move_to(0.0, 1.0); };

  /// [m/s^2]. T is Real, or a Dual over it.
  template <class Time, class T>
  T acceleration([[maybe_unused]] const Time& t, const T& x, [[maybe_unused]] const T& v) const {
    // The restoring force last: from x to the next x is the longest way through a step. Through many stages
    // it is from v to v, where drag makes the resistance the longer part.
    if constexpr (terms.drive && terms.law.has<Drag>() && at_nodes)
      return (T(force_(t)) - restoring(x)) - resistance(x, v);
    else if constexpr (terms.drive && depends_on_velocity)
      return (T(force_(t)) - resistance(x, v)) - restoring(x);
    else if constexpr (terms.drive)
      return T(force_(t)) - restoring(x);
    else if constexpr (depends_on_velocity)
      return -resistance(x, v) - restoring(x);
    else
      return -restoring(x);
  }

  /// The state at t of the motion through y0 at t0.
  State<Real> propagate(const Real& t0, const Real& t, const State<Real>& y0) const
      requires(is_linear(terms.law) && HasClosedForm<Force, Real>) {
    const LinearLaw<Real> linear{.decay_rate = law_.template of<Viscous>() / Real(2),
                                 .stiffness = law_.template of<Spring>()};
    return force_.propagate(linear, t0, t, y0);
  }

  /// The drive, to be made ready for a step.
  Force& force() { return force_; }

  /// The closed form has many pieces: best asked from state to state, not from the start of the run.
  static constexpr bool has_many_pieces = requires { Force::has_many_pieces; };

  /// [m/s^2] Bound on the error of the acceleration at times near t, from rounding of the drive.
  double acceleration_rounding(double t) const
      requires(terms.drive&& requires(const Force& f) { f.rounding(0.0); }) {
    return force_.rounding(t);
  }

  /// The first time after t [s] at which the drive is not smooth.
  double next_break(double t) const requires(terms.drive&& requires(const Force& f) { f.next_break(0.0); }) {
    return force_.next_break(t);
  }

  /// The law with the piece of the drive that holds at t, extended to all times: smooth, and the same until
  /// the next break.
  DrivenOscillator within(double t) const
      requires(terms.drive&& requires(const Force& f) { f.within(0.0); }) {
    DrivenOscillator smooth = *this;
    smooth.force_ = force_.within(t);
    return smooth;
  }

  /// Whether steps of this length [s] from t = 0 on have no break inside and no jump at their ends.
  bool is_smooth_in_steps(double step) const {
    if constexpr (requires { force_.is_smooth_in_steps(step); }) return force_.is_smooth_in_steps(step);
    return false;
  }

  /// The first time after t at which the drive may turn or jump.
  double next_turn(double t) const requires(terms.drive) { return force_.next_turn(t); }

  /// The linear law without its drive.
  LinearLaw<Real> free_law() const requires(is_linear(terms.law) && !terms.drive) {
    return {.decay_rate = law_.template of<Viscous>() / Real(2), .stiffness = law_.template of<Spring>()};
  }

  /// The same law for times `spacing` [s] apart, its drive from a table: move_to(first) makes the next
  /// `block` spacings ready.
  auto on_grid(double spacing) const requires(terms.drive&& std::is_same_v<Force, HarmonicForce<Real>>) {
    return DrivenOscillator<Real, terms, TabulatedForce<Real>>(law_, TabulatedForce<Real>(force_, spacing),
                                                               present_);
  }
  /// The same law for one step after another, its drive made ready for the step's nodes: move_to(t, h).
  template <class Nodes>
  auto on_nodes() const requires(terms.drive&& std::is_same_v<Force, HarmonicForce<Real>>) {
    return DrivenOscillator<Real, terms, NodeForce<Real, Nodes>>(law_, NodeForce<Real, Nodes>(force_),
                                                                 present_);
  }
  void move_to(double t, double h) requires at_nodes { force_.move_to(t, h); }

  static constexpr int block = TabulatedForce<Real>::block;
  void move_to(double first) requires(std::is_same_v<Force, TabulatedForce<Real>>) { force_.move_to(first); }

 private:
  template <class T>
  T restoring(const T& x) const {
    return restoring_force<terms.law>(law_, present_, x);
  }

  template <class T>
  T resistance(const T& x, const T& v) const {
    return resisting_force<terms.law>(law_, present_, x, v);
  }

  Coefficients<terms.law, Real> law_;  // per unit mass
  Force force_;
  [[no_unique_address]] std::conditional_t<terms.law == any_terms, Law, NoLaw> present_{};
};

/// The drive per unit mass.
template <class Real>
HarmonicForce<Real> force_of(const HarmonicDrive<Real>& drive, const Real& mass) {
  return {drive.amplitude / mass, drive.frequency, drive.phase};
}

/// Calls f.operator()<law>() with the smallest compiled law that has the terms present, or with any_terms.
template <class F>
decltype(auto) with_compiled_law(Law present, F&& f) {
  return [&]<std::size_t... i>(std::index_sequence<i...>)->decltype(auto) {
    using Returned = decltype(f.template operator()<any_terms>());
    const Law wanted = smallest_containing(compiled_laws, present).value_or(any_terms);
    if constexpr (std::is_void_v<Returned>) {
      if (!((wanted == compiled_laws[i] && (f.template operator()<compiled_laws[i]>(), true)) || ...))
        f.template operator()<any_terms>();
    } else {
      Returned returned{};
      if (!((wanted == compiled_laws[i] && (returned = f.template operator()<compiled_laws[i]>(), true)) ||
            ...))
        returned = f.template operator()<any_terms>();
      return returned;
    }
  }
  (std::make_index_sequence<std::size(compiled_laws)>{});
}

/// Calls f with the smooth law that has the terms with a coefficient other than zero, and returns what it
/// returns; the friction is left out. `driven`: under the force, else without it.
template <bool driven, class Real, class F>
decltype(auto) with_smooth_terms(const Oscillator<Real>& oscillator, const HarmonicForce<Real>& force,
                                 F&& f) {
  const Oscillator<Real> per_mass = divided_by_mass(oscillator);
  if constexpr (!each_set_of_terms) {
    return std::forward<F>(f)(AnyTerms(per_mass, driven ? force : HarmonicForce<Real>{}));
  } else {
    return with_compiled_law(
        law_of(oscillator).without(law_with<Friction>), [&]<Law law>() -> decltype(auto) {
          return f(DrivenOscillator<Real, Terms{.drive = driven, .law = law}>(per_mass, force));
        });
  }
}

/// Calls f with the DryFriction around the law. Inside is the general law (any_terms), or, without a drive
/// and other terms, the linear one: that has a closed form.
template <class Real, class F>
decltype(auto) with_dry_friction(const Oscillator<Real>& oscillator, const HarmonicDrive<Real>& drive,
                                 F&& f) {
  [[maybe_unused]] const Terms present = terms_of(oscillator, drive);
  const Oscillator<Real> per_mass = divided_by_mass(oscillator);
  const HarmonicForce<Real> force = force_of(drive, oscillator.mass);
  [[maybe_unused]] const auto rub = [&]<Terms terms>() -> decltype(auto) {
    return std::forward<F>(f)(DryFriction(DrivenOscillator<Real, terms>(per_mass, force), per_mass.friction,
                                          per_mass.static_friction));
  };
  if constexpr (!each_set_of_terms) {
    return std::forward<F>(f)(
        AnyFriction(AnyTerms(per_mass, force), per_mass.friction, per_mass.static_friction));
  } else {
    if (present.drive) return rub.template operator()<Terms{.drive = true, .law = any_terms}>();
    if (!is_linear(present.law.without(law_with<Friction>)))
      return rub.template operator()<Terms{.law = any_terms}>();
    return rub.template operator()<Terms{.law = linear_terms}>();
  }
}

/// Calls f with the DrivenOscillator that has the terms with a coefficient other than zero, with friction the
/// DryFriction around it, and returns what it returns.
template <class Real, class F>
decltype(auto) with_terms(const Oscillator<Real>& oscillator, const HarmonicDrive<Real>& drive, F&& f) {
  const Terms present = terms_of(oscillator, drive);
  const HarmonicForce<Real> force = force_of(drive, oscillator.mass);
  if (present.law.has<Friction>()) return with_dry_friction(oscillator, drive, std::forward<F>(f));
  if (present.drive) return with_smooth_terms<true>(oscillator, force, std::forward<F>(f));
  return with_smooth_terms<false>(oscillator, force, std::forward<F>(f));
}

}  // namespace cromer::core
