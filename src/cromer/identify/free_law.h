// A law of free motion as the model's own system, over any scalar.
#pragma once

#include <cstddef>
#include <utility>

#include "cromer/identify/law.h"
#include "cromer/identify/phases.h"
#include "cromer/identify/sloped_law.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/pendulum.h"

namespace cromer {

/// The coefficients per unit mass and the state at the first time.
template <class Real>
struct FreeStart {
  Oscillator<Real> per_mass;
  State<Real> state;
  bool pendulum = false;
};

/// Calls f.template operator()<law>() with the law as a constant, and returns what it returns. Viscous
/// damping, which costs next to nothing, is always among its terms; in the page, which must be small, others
/// whose coefficients are 0 may be, and whether it is a pendulum is told at run time.
template <class F>
auto with_constant(const Law& law, F&& f) {
  constexpr auto made_of = [](std::size_t bits) {
    return Law{.viscous = true,
               .drag = (bits & 1) != 0,
               .friction = (bits & 2) != 0,
               .cubic = (bits & 4) != 0,
               .pendulum = (bits & 8) != 0};
  };
  std::size_t wanted =
      (law.drag ? 1U : 0U) + (law.friction ? 2U : 0U) + (law.cubic ? 4U : 0U) + (law.pendulum ? 8U : 0U);
  if constexpr (!each_set_of_terms) wanted = law.friction ? 7U : law.cubic ? 5U : 1U;
  decltype(f.template operator()<Law{}>()) returned{};
  const auto call = [&]<std::size_t... bits>(std::index_sequence<bits...>) {
    ((bits == wanted ? void(returned = f.template operator()<made_of(bits)>()) : void()), ...);
  };
  if constexpr (each_set_of_terms)
    call(std::make_index_sequence<16>{});
  else
    call(std::index_sequence<1, 5, 7>{});
  return returned;
}

/// The smooth terms.
template <Law law, class Real>
auto smooth_system(const FreeStart<Real>& start) {
  constexpr Terms terms{.damping = true, .cubic = law.cubic, .drag = law.drag};
  if constexpr (!each_set_of_terms) {
    return AnyTerms(start.per_mass, {}, start.pendulum);
  } else if constexpr (law.pendulum) {
    Oscillator<Real> rest = start.per_mass;
    rest.stiffness = Real(0);
    return Pendulum(DrivenOscillator<Real, terms>(rest, {}), start.per_mass.stiffness);
  } else {
    return DrivenOscillator<Real, terms>(start.per_mass, {});
  }
}

/// The same with derivatives.
template <Law law, std::size_t N>
auto smooth_system(const FreeStart<Dual<double, N>>& start) {
  return SlopedLaw<law, N>(start.per_mass, start.pendulum);
}

/// A smooth system with dry friction.
template <class S, class Real>
auto with_friction(const S& smooth, const Real& friction) {
  return DryFriction(smooth, friction, friction);
}
inline AnyFriction with_friction(const AnyTerms& smooth, double friction) {
  return {smooth, friction, friction};
}

/// The motion of the law from a start over the scalar Real; `values` is the same start without derivatives.
template <Law law, class Real>
auto phases_of(const FreeStart<Real>& start, [[maybe_unused]] const FreeStart<double>& values) {
  const auto smooth = smooth_system<law>(start);
  if constexpr (law.friction) {
    const auto system = with_friction(smooth, start.per_mass.friction);
    const auto same = with_friction(smooth_system<law>(values), values.per_mass.friction);
    return StickSlipPhases(system, same, start.state);
  } else {
    return SmoothPhases(smooth, start.state);
  }
}

}  // namespace cromer
